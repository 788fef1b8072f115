// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/stated_time.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/signal/signal_unit.h"
#include "core/text/decimal_text.h"
#include "core/text/name_text.h"
#include "core/text/units.h"

namespace drillwave {

namespace {

constexpr std::int64_t daySeconds = 86400;
constexpr std::size_t longestStamp = 48;

/// Digits at the beginning, taken off; nothing where there are none or more than `most`.
std::optional<int> takeNumber(std::string_view& text, std::size_t most) {
    std::size_t count = 0;
    int value = 0;
    while (count < text.size() && text[count] >= '0' && text[count] <= '9' && count <= most)
        value = 10 * value + (text[count++] - '0');
    if (count == 0 || count > most) return std::nullopt;
    text.remove_prefix(count);
    return value;
}

bool takeSign(std::string_view& text, std::string_view wanted) {
    if (text.empty() || wanted.find(text.front()) == std::string_view::npos) return false;
    text.remove_prefix(1);
    return true;
}

/// Days since 1970 of a date at the beginning, taken off with the blank or T behind it.
std::optional<std::int64_t> takeDate(std::string_view& text) {
    std::string_view rest = text;
    std::array<int, 3> parts{};
    char sign = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (i > 0) {
            if (rest.empty() || (i == 2 && rest.front() != sign)) return std::nullopt;
            sign = rest.front();
            if (!takeSign(rest, "-/.")) return std::nullopt;
        }
        const std::optional<int> part = takeNumber(rest, 4);
        if (!part) return std::nullopt;
        parts[i] = *part;
    }
    if (!takeSign(rest, " T,")) return std::nullopt;
    int year = parts[0], month = parts[1], day = parts[2];
    if (parts[0] <= 31 && sign == '/') month = parts[0], day = parts[1], year = parts[2];
    if (parts[0] <= 31 && sign != '/') day = parts[0], year = parts[2];
    if (month > 12) std::swap(month, day);
    if (year < 100) year += 2000;
    const std::chrono::year_month_day date(std::chrono::year(year),
                                           std::chrono::month(static_cast<unsigned>(month)),
                                           std::chrono::day(static_cast<unsigned>(day)));
    if (!date.ok()) return std::nullopt;
    text = trimmed(rest);
    return std::chrono::sys_days(date).time_since_epoch().count();
}

/// Takes "Z", "+01:00" and "UTC" off: a record does not change its zone.
void takeZone(std::string_view& text) {
    for (const std::string_view zone : {"Z", " UTC", " GMT"})
        if (text.ends_with(zone)) return text.remove_suffix(zone.size());
    constexpr std::size_t zoneLength = 6;  // "+01:00"
    if (text.size() > zoneLength) {
        const char sign = text[text.size() - zoneLength];
        if ((sign == '+' || sign == '-') && text[text.size() - 3] == ':') text.remove_suffix(zoneLength);
    }
}

/// Beside the first samples metadata are looked for in so many lines.
constexpr std::size_t mostLinesBeside = 60;

constexpr std::string_view rateWords[] = {"sampling rate",
                                          "sample rate",
                                          "samplerate",
                                          "samplingrate",
                                          "sampling_rate",
                                          "sample_rate",
                                          "sampling frequency",
                                          "sample frequency",
                                          "sampling_frequency",
                                          "sampling freq",
                                          "sample freq",
                                          "scan rate",
                                          "acquisition rate",
                                          "acq rate",
                                          "data rate",
                                          "abtastrate",
                                          "abtastfrequenz",
                                          "abtast-rate",
                                          "messrate",
                                          "samplingrate",
                                          "samplingsfrekvens",
                                          "samplingsfrekvensen",
                                          "samplingshastighet",
                                          "samplingsfrequenz",
                                          "samplingfrequenz",
                                          "sampelfrekvens",
                                          "provtagningsfrekvens",
                                          "records per second",
                                          "samples per second",
                                          "samples/s",
                                          "digitizing rate",
                                          "sampling-rate",
                                          "sample-rate",
                                          "samplingstakt",
                                          "samplings-frekvens",
                                          "samplingfrekvens"};
constexpr std::string_view intervalWords[] = {"sample interval",
                                              "sampling interval",
                                              "sample_interval",
                                              "sampling_interval",
                                              "sample period",
                                              "sampling period",
                                              "sampling time",
                                              "sample time",
                                              "time interval",
                                              "time step",
                                              "timestep",
                                              "time_step",
                                              "time increment",
                                              "x increment",
                                              "xincrement",
                                              "x_increment",
                                              "xincr",
                                              "x-increment",
                                              "horizontal interval",
                                              "delta t",
                                              "delta_t",
                                              "deltat",
                                              "delta x",
                                              "delta_x",
                                              "time per sample",
                                              "abtastintervall",
                                              "abtastzeit",
                                              "abtastperiode",
                                              "zeitschritt",
                                              "zeitintervall",
                                              "zeitinkrement",
                                              "samplingsintervall",
                                              "samplingintervall",
                                              "samplingstid",
                                              "tidssteg",
                                              "tidsintervall",
                                              "tidsteg",
                                              "sample spacing",
                                              "x interval",
                                              "interval"};
/// Too short to be looked for inside of other words.
constexpr std::string_view shortRateWords[] = {"fs",        "f_s",      "sr",      "rate",
                                               "frequency", "frequenz", "frekvens"};
constexpr std::string_view shortIntervalWords[] = {"dt", "d_t", "ts", "\u03b4t", "\u0394t"};
constexpr std::string_view signalUnitWords[] = {"vertical units", "vertical unit", "y unit", "y units",
                                                "y-unit",         "y_unit",        "yunit",  "unit y",
                                                "einheit y",      "enhet y"};
constexpr std::string_view timeUnitWords[] = {
    "horizontal units", "horizontal unit", "x unit",      "x units",   "x-unit",  "x_unit",   "xunit",
    "time unit",        "time units",      "zeiteinheit", "einheit x", "enhet x", "tidsenhet"};

/// The length of the word with which a text begins, 0 if it begins with none of them.
std::size_t wordLength(std::string_view lower, std::span<const std::string_view> words, bool whole) {
    std::size_t longest = 0;
    for (const std::string_view word : words) {
        if (!lower.starts_with(word) || word.size() < longest) continue;
        const std::string_view rest = lower.substr(word.size());
        const bool ends = rest.empty() || std::string_view(" \t:=;,\"[(/").find(rest.front()) != rest.npos;
        if (ends || (!whole && rest.front() == 's')) longest = word.size();
    }
    return longest;
}

/// A number, and the word behind it or in brackets before it.
struct Stated {
    double value = 0;
    std::string unit;
};

std::optional<std::string> inBrackets(std::string_view& text) {
    const char open = text.empty() ? '\0' : text.front();
    if (open != '[' && open != '(') return std::nullopt;
    const std::size_t end = text.find(open == '[' ? ']' : ')');
    if (end == std::string_view::npos) return std::nullopt;
    const std::string unit(trimmed(text.substr(1, end - 1)));
    text.remove_prefix(end + 1);
    return unit;
}

std::string_view withoutSigns(std::string_view text) {
    const std::size_t at = text.find_first_not_of(" \t:=;,\"|");
    return at == std::string_view::npos ? std::string_view() : text.substr(at);
}

std::optional<Stated> statedBehind(std::string_view text) {
    Stated stated;
    text = withoutSigns(text);
    // "per channel", "in kHz", "(kHz)" before the number.
    for (const std::string_view word : {"per channel", "je kanal", "in ", "i "})
        if (lowerCase(std::string(text.substr(0, word.size()))) == word) {
            text = withoutSigns(text.substr(word.size()));
            if (word.ends_with(' ')) {
                const std::size_t end = std::min(text.find_first_of(" \t:=;,\""), text.size());
                stated.unit = text.substr(0, end);
                text.remove_prefix(end);
            }
        }
    if (const auto unit = inBrackets(text)) stated.unit = *unit;
    text = withoutSigns(text);
    // "1,5 MHz" as well as "1.5 MHz" and "5 000 000": digits go on to the first character that is none.
    std::string digits;
    std::size_t at = 0;
    const auto isDigit = [&](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
    for (; at < text.size(); ++at) {
        const char c = text[at];
        const bool between = at > 0 && isDigit(at - 1) && isDigit(at + 1);
        const bool group =
            between && (c == ' ' || c == '\'') && isDigit(at + 2) && isDigit(at + 3) && !isDigit(at + 4);
        const bool power = (c == 'e' || c == 'E') && at > 0 &&
                           (isDigit(at + 1) || (at + 1 < text.size() && isDigit(at + 2) &&
                                                (text[at + 1] == '-' || text[at + 1] == '+')));
        if (isDigit(at) || c == '.' || (at == 0 && (c == '+' || c == '-')))
            digits += c;
        else if (c == ',' && between && digits.find('.') == std::string::npos)
            digits += '.';
        else if (power) {
            digits += 'e';
            if (!isDigit(at + 1)) digits += text[++at];
        } else if (!group)
            break;
    }
    const std::size_t length = numberLength(digits);
    if (length == 0 || length != digits.size()) return std::nullopt;
    const std::optional<double> value = scaledNumber(digits, 0);
    if (!value || !(*value > 0)) return std::nullopt;
    stated.value = *value;
    std::string_view behind = withoutSigns(text.substr(at));
    if (const auto unit = inBrackets(behind)) {
        stated.unit = *unit;
    } else if (stated.unit.empty()) {
        std::size_t end = std::min(behind.find_first_of(" \t;,\"|"), behind.size());
        if (behind.starts_with("samples per second")) return Stated{stated.value, "S/s"};
        stated.unit = behind.substr(0, end);
    }
    return stated;
}

class MetadataReader {
  public:
    explicit MetadataReader(DetectedTable& table) : m_table(table) {}

    void read(std::string_view line) {
        const std::string plain = hasWideCharacters(line) ? withPlainSigns(line) : std::string(line);
        const std::string lower = lowerCase(plain);
        for (std::size_t at = 0; at < plain.size(); ++at) {
            // Words begin where a cell or another word ends.
            const auto isLetter = [&](char c) {
                return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ||
                       static_cast<unsigned char>(c) >= 0x80 || c == '_';
            };
            if (at > 0 && isLetter(lower[at - 1])) continue;
            const std::string_view rest = std::string_view(lower).substr(at);
            const std::string_view text = std::string_view(plain).substr(at);
            const bool begins = isCellStart(plain, at);
            if (const std::size_t n = lengthOf(rest, rateWords, shortRateWords, begins)) {
                takeRate(text, n);
            } else if (const std::size_t m = lengthOf(rest, intervalWords, shortIntervalWords, begins)) {
                takeInterval(text, m);
            } else if (const std::size_t k = wordLength(rest, signalUnitWords, true); k && begins) {
                m_signalUnit = firstWord(text.substr(k));
            } else if (const std::size_t l = wordLength(rest, timeUnitWords, true); l && begins) {
                m_timeUnit = firstWord(text.substr(l));
            }
        }
    }

    void finish() {
        std::vector<TableColumn*> numeric;
        for (TableColumn& column : m_table.columns)
            if (column.isNumeric) numeric.push_back(&column);
        if (!m_signalUnit.empty() && isKnownUnit(m_signalUnit) && numeric.size() <= 2 && !numeric.empty() &&
            numeric.back()->unit.empty())
            numeric.back()->unit = m_signalUnit;
        if (!m_timeUnit.empty() && findTimeUnit(m_timeUnit) && numeric.size() == 2 &&
            numeric.front()->unit.empty())
            numeric.front()->unit = m_timeUnit;
    }

  private:
    static std::size_t lengthOf(std::string_view rest, std::span<const std::string_view> words,
                                std::span<const std::string_view> shortWords, bool begins) {
        if (const std::size_t length = wordLength(rest, words, false)) return length;
        return begins ? wordLength(rest, shortWords, true) : 0;
    }

    static bool isCellStart(std::string_view line, std::size_t at) {
        const std::string_view before = trimmed(line.substr(0, at));
        return before.empty() ||
               std::string_view(",;\t|\"#%/!").find(before.back()) != std::string_view::npos;
    }

    static std::string firstWord(std::string_view text) {
        text = withoutSigns(text);
        if (const auto unit = inBrackets(text)) return *unit;
        return std::string(text.substr(0, std::min(text.find_first_of(" \t;,\"|"), text.size())));
    }

    void takeRate(std::string_view text, std::size_t length) {
        const std::optional<Stated> stated = statedBehind(text.substr(length));
        if (!stated) return;
        const std::optional<double> unit = findRateUnit(stated->unit);
        // "samples per second" and "samples/s" are their own unit.
        const std::string word = lowerCase(std::string(text.substr(0, length)));
        const bool isOwnUnit = word.find("per second") != std::string::npos || word == "samples/s";
        take(unit || isOwnUnit, stated->value * unit.value_or(1), text, *stated);
    }

    void takeInterval(std::string_view text, std::size_t length) {
        const std::optional<Stated> stated = statedBehind(text.substr(length));
        if (!stated) return;
        const std::optional<double> unit = findTimeUnit(stated->unit);
        take(unit.has_value(), 1 / (stated->value * unit.value_or(1)), text, *stated);
    }

    void take(bool hasUnit, double rate, std::string_view text, const Stated&) {
        if (!std::isfinite(rate) || !(rate > 0)) return;
        if (m_table.rate || (!hasUnit && m_table.bareRate)) return;
        (hasUnit ? m_table.rate : m_table.bareRate) = rate;
        m_table.rateText = shortened(text);
    }

    DetectedTable& m_table;
    std::string m_signalUnit, m_timeUnit;
};

/// The steps of a column of numbers, where they are even.
std::optional<double> evenStep(std::span<const std::string> lines, const DetectedTable& table,
                               std::size_t column) {
    constexpr std::size_t enough = 200;
    TableRow row;
    std::vector<double> values;
    for (std::size_t i = table.firstLine - 1; i < lines.size() && values.size() < enough; ++i) {
        const std::vector<std::string_view>& cells = row.split(lines[i], table.format.separator);
        if (column >= cells.size()) continue;
        if (const auto value = cellNumber(cells[column], table.format)) values.push_back(*value);
    }
    if (values.size() < 3) return std::nullopt;
    return (values.back() - values.front()) / static_cast<double>(values.size() - 1);
}

}  // namespace

std::optional<TimeStamp> timeStamp(std::string_view cell) {
    std::string_view text = trimmed(cell);
    if (text.size() > longestStamp || text.find(':') == std::string_view::npos) return std::nullopt;
    TimeStamp stamp;
    if (const std::optional<std::int64_t> days = takeDate(text)) {
        stamp.hasDate = true;
        stamp.seconds = *days * daySeconds;
    }
    takeZone(text);
    bool isAfternoon = false, hasHalf = false;
    for (const auto& [word, afternoon] :
         {std::pair{"AM", false}, std::pair{"PM", true}, std::pair{"am", false}, std::pair{"pm", true}})
        if (text.ends_with(word)) {
            hasHalf = true;
            isAfternoon = afternoon;
            text = trimmed(text.substr(0, text.size() - 2));
            break;
        }
    std::array<int, 3> parts{};
    std::size_t count = 0;
    do {
        const std::optional<int> part = takeNumber(text, 2);
        if (!part || count == parts.size()) return std::nullopt;
        parts[count++] = *part;
    } while (takeSign(text, ":"));
    if (count < 2) return std::nullopt;
    if (!text.empty()) {
        // Also "09:11:02:000100", microseconds behind a colon, is not read: nobody says what they are.
        if (!takeSign(text, ".,") || text.empty() || text.find_first_not_of("0123456789") != text.npos)
            return std::nullopt;
        stamp.fraction = parseNumber("0." + std::string(text)).value_or(0);
        if (count == 2) parts = {0, parts[0], parts[1]};
    }
    if (parts[0] > 24 || parts[1] > 59 || parts[2] > 60) return std::nullopt;
    if (hasHalf) parts[0] = parts[0] % 12 + (isAfternoon ? 12 : 0);
    stamp.seconds += 3600 * parts[0] + 60 * parts[1] + parts[2];
    return stamp;
}

double secondsSince(const TimeStamp& first, const TimeStamp& stamp) {
    std::int64_t seconds = stamp.seconds - first.seconds;
    if (!stamp.hasDate && seconds < -daySeconds / 2) seconds += daySeconds;
    return static_cast<double>(seconds) + (stamp.fraction - first.fraction);
}

void readStatedRate(std::span<const std::string> lines, DetectedTable& table) {
    MetadataReader reader(table);
    const std::size_t header = std::min(table.firstLine - 1, lines.size());
    for (std::size_t i = 0; i < header; ++i) reader.read(lines[i]);
    // Beside the samples: the cells of columns that are none of theirs.
    const auto isBeside = [](const TableColumn& column) { return !column.isNumeric && !column.isStamp; };
    if (std::ranges::any_of(table.columns, isBeside)) {
        TableRow row;
        for (std::size_t i = header; i < std::min(lines.size(), header + mostLinesBeside); ++i) {
            std::string beside;
            const std::vector<std::string_view>& cells = row.split(lines[i], table.format.separator);
            for (std::size_t c = 0; c < std::min(cells.size(), table.columns.size()); ++c)
                if (isBeside(table.columns[c]) && !cells[c].empty())
                    beside += (beside.empty() ? "" : ";") + std::string(cells[c]);
            if (!beside.empty()) reader.read(beside);
        }
    }
    reader.finish();
    // An interval that is stated says in what the times are.
    constexpr double same = 0.01;
    if (!table.rate) return;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        TableColumn& column = table.columns[c];
        if (!column.isNumeric || !column.unit.empty() || column.isIndex) continue;
        if (!column.name.empty() && !isTimeName(column.name)) continue;
        const std::optional<double> step = evenStep(lines, table, c);
        if (!step || !(*step > 0)) continue;
        for (const std::string_view unit : {"s", "ms", "us", "ns"})
            if (std::abs(*step * *findTimeUnit(unit) * *table.rate - 1) < same) {
                column.unit = unit;
                return;
            }
    }
}

}  // namespace drillwave
