// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/table_row.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/text/decimal_text.h"
#include "core/text/name_text.h"
#include "core/text/units.h"

namespace drillwave {
namespace {

bool isBlank(char c) {
    return c == ' ' || c == '\t';
}

std::size_t afterBlanks(std::string_view line, std::size_t at) {
    while (at < line.size() && isBlank(line[at])) ++at;
    return at;
}

}  // namespace

// From behind the opening quote; a doubled quote is one of the text. Ends behind the closing quote.
std::string_view TableRow::quotedCell(std::string_view line, std::size_t& at) {
    std::string& text = m_unquoted.emplace_back();
    for (++at; at < line.size(); ++at) {
        if (line[at] == '"' && (++at >= line.size() || line[at] != '"')) break;
        text += line[at];
    }
    return trimmed(text);
}

const std::vector<std::string_view>& TableRow::split(std::string_view line, char separator,
                                                     std::size_t most) {
    m_cells.clear();
    m_unquoted.clear();
    const bool blanks = separator == ' ';
    std::size_t at = 0;
    if (blanks) line = trimmed(line);
    while (m_cells.size() < most) {
        if (separator != '\t') at = afterBlanks(line, at);
        const auto ends = [&](char c) { return blanks ? isBlank(c) : c == separator; };
        if (at < line.size() && line[at] == '"') {
            m_cells.push_back(quotedCell(line, at));
            while (at < line.size() && !ends(line[at])) ++at;
        } else {
            const std::size_t begin = at;
            while (at < line.size() && !ends(line[at])) ++at;
            m_cells.push_back(trimmed(line.substr(begin, at - begin)));
        }
        if (at >= line.size()) break;
        ++at;
    }
    return m_cells;
}

namespace {

bool isCellDigit(char c) {
    return c >= '0' && c <= '9';
}

std::size_t digitCount(std::string_view text) {
    std::size_t count = 0;
    while (count < text.size() && isCellDigit(text[count])) ++count;
    return count;
}

/// The length of ",676" or " 676" at the beginning: a sign of those and three digits, no fourth.
std::size_t groupLength(std::string_view text, std::string_view parting) {
    if (text.empty() || parting.find(text.front()) == std::string_view::npos) return 0;
    return digitCount(text.substr(1)) == 3 ? 4 : 0;
}

/// A number at the beginning of a text, in C notation.
struct PlainNumber {
    std::string text;
    std::size_t length = 0;  // of what was read; 0 where there is no number
};

PlainNumber plainNumber(std::string_view text, const RowFormat& format) {
    const char decimal = format.decimal == DecimalSign::point ? '.' : ',';
    const char other = decimal == '.' ? ',' : '.';
    PlainNumber number;
    std::size_t at = 0;
    if (at < text.size() && (text[at] == '-' || text[at] == '+')) number.text += text[at++];
    const std::size_t whole = digitCount(text.substr(at));
    number.text += text.substr(at, whole);
    at += whole;
    std::size_t digits = whole;
    std::size_t end = at;
    std::string grouped;
    // All groups are parted by the same sign.
    const std::string sign = at < text.size() ? std::string(1, text[at]) : std::string();
    if (whole > 0 && whole <= 3 && sign.find_first_of(std::string(" '") + other) != std::string::npos &&
        !(whole == 1 && text[end - 1] == '0'))
        while (groupLength(text.substr(end), sign) > 0) {
            grouped += text.substr(end + 1, 3);
            end += 4;
        }
    const bool hasDecimals = end < text.size() && text[end] == decimal;
    if (!grouped.empty() && (sign.front() != other || format.otherSignGroups || hasDecimals)) {
        number.text += grouped;
        digits += grouped.size();
        at = end;
    }
    if (at < text.size() && text[at] == decimal) {
        const std::size_t decimals = digitCount(text.substr(at + 1));
        if (digits + decimals > 0) {
            number.text += '.';
            number.text += text.substr(at + 1, decimals);
            at += 1 + decimals;
            digits += decimals;
        }
    }
    if (digits == 0) return {};
    if (at < text.size() && std::string_view("eEdD").find(text[at]) != std::string_view::npos) {
        const std::size_t from = at + 1;
        const std::size_t exponentSign =
            from < text.size() && (text[from] == '-' || text[from] == '+') ? 1 : 0;
        if (const std::size_t power = digitCount(text.substr(from + exponentSign)); power > 0) {
            number.text += 'e';
            number.text += text.substr(from, exponentSign + power);
            at = from + exponentSign + power;
        }
    }
    number.length = at;
    return number;
}

constexpr std::string_view overloadWords[] = {
    "ovl",       "ol",          "ovr",      "ovrng",     "over",       "inf",       "-inf",      "+inf",
    "infinity",  "-infinity",   "\u221e",   "-\u221e",   "+\u221e",    "overload",  "overflow",  "ovfl",
    "overrange", "over range",  "clipped",  "1.#inf",    "-1.#inf",    "off scale", "over load", "überlauf",
    "o.l.",      "übersteuert", "1.#inf00", "-1.#inf00", "underrange", "udr"};

constexpr std::string_view missingWords[] = {"",
                                             "nan",
                                             "-nan",
                                             "+nan",
                                             "n/a",
                                             "#n/a",
                                             "na",
                                             "-",
                                             "--",
                                             "---",
                                             "----",
                                             "-----",
                                             "null",
                                             "nil",
                                             "none",
                                             "#nv",
                                             "n.a.",
                                             "n.v.",
                                             "n. v.",
                                             "k.a.",
                                             "k. a.",
                                             "#value!",
                                             "#div/0!",
                                             "#ref!",
                                             "#name?",
                                             "#num!",
                                             "#null!",
                                             "#n/a n/a",
                                             "#wert!",
                                             "#bezug!",
                                             "#zahl!",
                                             "#saknas!",
                                             "#värdefel!",
                                             "#division/0!",
                                             "#ogiltigt!",
                                             "#referens!",
                                             "#namn?",
                                             "#valeur!",
                                             "1.#qnan",
                                             "-1.#qnan",
                                             "1.#ind",
                                             "-1.#ind",
                                             "1.#nan",
                                             "-1.#ind00",
                                             "1.#qnan0",
                                             "-1.#ind0",
                                             "nan(ind)",
                                             "-nan(ind)",
                                             "missing",
                                             "invalid",
                                             "error",
                                             "err",
                                             "?",
                                             "??",
                                             "*",
                                             "***",
                                             ".",
                                             "..",
                                             "no data",
                                             "nodata",
                                             "<null>",
                                             "(null)",
                                             "\u2013",
                                             "\u2014",
                                             "\u2212",
                                             "undef",
                                             "void",
                                             "bad",
                                             "saknas",
                                             "fehlt",
                                             "ungültig",
                                             "#####",
                                             "n.d.",
                                             "#calc!",
                                             "#spill!",
                                             "#überlauf!",
                                             "not a number",
                                             "-nan(snan)",
                                             "nan(snan)",
                                             "####"};

constexpr std::size_t longestMissingWord = 16;

bool isWordOf(std::span<const std::string_view> words, std::string_view cell) {
    if (cell.size() > longestMissingWord) return false;
    const std::string lower = lowerCase(std::string(cell));
    return std::ranges::find(words, std::string_view(lower)) != words.end();
}

}  // namespace

std::optional<double> cellNumber(std::string_view cell, const RowFormat& format) {
    // As most cells are: nothing to be put right.
    if (format.decimal == DecimalSign::point)
        if (const std::size_t length = numberLength(cell); length > 0 && length == cell.size())
            return scaledNumber(cell, 0);
    if (cell.empty() || cell.size() > 64) return std::nullopt;
    const std::string plain = hasWideCharacters(cell) ? withPlainSigns(cell) : std::string(cell);
    const std::string_view text = trimmed(plain);
    const PlainNumber number = plainNumber(text, format);
    if (number.length == 0 || number.length != text.size()) return std::nullopt;
    return scaledNumber(number.text, 0);
}

std::string plainCell(std::string_view cell, const RowFormat& format) {
    if (cell.empty() || cell.size() > 256) return std::string(cell);
    const std::string plain = hasWideCharacters(cell) ? withPlainSigns(cell) : std::string(cell);
    const std::string_view text = trimmed(plain);
    const PlainNumber number = plainNumber(text, format);
    // Words that only begin with a number stay: "3rd hole", "1,2,3".
    const std::string_view rest = text.substr(number.length);
    if (number.length == 0 || (!rest.empty() && (isCellDigit(rest.front()) || rest.front() == ',' ||
                                                 rest.front() == '.' || rest.front() == '-')))
        return std::string(cell);
    return number.text + std::string(rest);
}

SignEvidence signEvidence(std::string_view cell) {
    SignEvidence evidence;
    if (cell.empty() || cell.size() > 64) return evidence;
    const std::string plain = hasWideCharacters(cell) ? withPlainSigns(cell) : std::string(cell);
    std::string_view text = trimmed(plain);
    if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
    const std::size_t whole = digitCount(text);
    std::size_t at = whole, groups = 0;
    char sign = 0;
    while (at < text.size() && std::string_view(",.' ").find(text[at]) != std::string_view::npos) {
        if (sign != 0 && text[at] != sign) break;
        sign = text[at];
        if (groupLength(text.substr(at), std::string_view(&sign, 1)) == 0) break;
        at += 4;
        ++groups;
    }
    if (sign == 0) return evidence;
    const auto isDecimal = [&](char found) { (found == '.' ? evidence.point : evidence.comma) = true; };
    const bool isBlank = sign == ' ' || sign == '\'';
    if (groups > 0 && isBlank) evidence.groups = sign;
    if (at < text.size() && (text[at] == '.' || text[at] == ',')) {
        // "3,676.8", or "0.5" and "1234.5678", where the groups end at once.
        if (groups > 0 && text[at] != sign && whole <= 3) evidence.groups = sign;
        if (groups == 0 || text[at] != sign) isDecimal(text[at]);
        return evidence;
    }
    if (groups == 0 || isBlank) return evidence;
    if (groups == 1 && (whole == 0 || whole > 3 || text.front() == '0')) {
        isDecimal(sign);
    } else if (groups == 1 && at < text.size() &&
               std::string_view("eE").find(text[at]) != std::string_view::npos) {
        isDecimal(sign);
    } else if (groups == 1) {
        evidence.ambiguous = true;
    } else if (whole <= 3) {
        evidence.groups = sign;
        isDecimal(sign == '.' ? ',' : '.');
    }
    return evidence;
}

bool isOverload(std::string_view cell) {
    if (isWordOf(overloadWords, cell)) return true;
    const std::optional<double> value = parseNumber(cell);
    return value && std::abs(*value) >= overloadValue;
}

bool isMissing(std::string_view cell) {
    return isWordOf(missingWords, cell) || isWordOf(overloadWords, cell);
}

bool isPassedOver(std::string_view line, char separator) {
    const std::string_view text = trimmed(line);
    if (text.empty()) return true;
    if (text.front() != '#') return false;
    const std::size_t end = separator == ' ' ? text.find_first_of(" \t") : text.find(separator);
    return !isMissing(trimmed(text.substr(0, end)));
}

}  // namespace drillwave
