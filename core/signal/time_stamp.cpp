// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/time_stamp.h"

#include <array>
#include <chrono>
#include <string>

#include "core/text/decimal_text.h"
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

}  // namespace drillwave
