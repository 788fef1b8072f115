// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/column_heading.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/signal/signal_unit.h"
#include "core/text/decimal_text.h"
#include "core/text/name_text.h"
#include "core/text/units.h"

namespace drillwave {
namespace {

bool isTimeUnit(std::string_view word) {
    return findTimeUnit(word) && word != "min";  // a minimum
}

/// Whether a last word without brackets is a unit, and no word of the name: "strain", "ε".
bool isUnitWord(std::string_view word) {
    if (isTimeUnit(word)) return true;
    const std::optional<NamedSignalUnit> found = findSignalUnit(word);
    if (word == "bar") return false;  // "incident bar"
    return found && (found->kind != SignalKind::strain || found->unit.name == word ||
                     word.find_first_of("/%") != std::string_view::npos || word.starts_with("\u00b5") ||
                     word.starts_with("\u03bc"));
}

/// Whether "name/unit" and "name_unit" are that, and not a rate such as "m/s".
bool isUnitBehind(std::string_view name, std::string_view unit) {
    if (name.empty() || !isUnitWord(unit)) return false;
    return !isTimeUnit(unit) || isTimeName(name);
}

TableColumn parts(std::string_view name, std::string_view unit) {
    return {std::string(trimmed(name)), std::string(trimmed(unit)), false};
}

}  // namespace

bool isKnownUnit(std::string_view word) {
    return findTimeUnit(word) || findSignalUnit(word);
}

namespace {

/// Brackets in a heading: what is in them, and what is around.
struct Bracketed {
    std::string name;
    std::string_view unit;
    bool isLast = false;
};

/// All of them, from the last to the first.
std::vector<Bracketed> bracketsOf(std::string_view cell) {
    std::vector<Bracketed> found;
    constexpr auto npos = std::string_view::npos;
    for (std::size_t end = cell.find_last_of("])"); end != npos && end > 0;
         end = cell.find_last_of("])", end - 1)) {
        const std::size_t begin = cell.rfind(cell[end] == ']' ? '[' : '(', end);
        if (begin == npos) continue;
        const std::string_view before = trimmed(cell.substr(0, begin)),
                               behind = trimmed(cell.substr(end + 1));
        std::string name(before);
        if (!before.empty() && !behind.empty()) name += ' ';
        name += behind;
        found.push_back({name, trimmed(cell.substr(begin + 1, end - begin - 1)), behind.empty()});
    }
    return found;
}

}  // namespace

TableColumn columnOf(std::string_view heading) {
    constexpr auto npos = std::string_view::npos;
    const std::string plain = hasWideCharacters(heading) ? withPlainSigns(heading) : std::string(heading);
    const std::string_view cell = trimmed(plain);
    const std::vector<Bracketed> brackets = bracketsOf(cell);
    for (const Bracketed& bracket : brackets)
        if (isKnownUnit(bracket.unit)) return parts(bracket.name, bracket.unit);
    for (const Bracketed& bracket : brackets)
        if (bracket.isLast) return parts(bracket.name, bracket.unit);
    for (const std::string_view word : {" / ", " in ", " i "})
        if (const std::size_t at = cell.rfind(word);
            at != npos && (word != " i " || isUnitWord(trimmed(cell.substr(at + word.size())))))
            return parts(cell.substr(0, at), cell.substr(at + word.size()));
    for (const char sign : {',', ':', ';'})
        if (const std::size_t at = cell.rfind(sign); at != npos && isUnitWord(trimmed(cell.substr(at + 1))))
            return parts(cell.substr(0, at), cell.substr(at + 1));
    if (const std::size_t blank = cell.rfind(' '); blank != npos && isUnitWord(cell.substr(blank + 1)))
        return parts(cell.substr(0, blank), cell.substr(blank + 1));
    // A unit has slashes itself, a name has underscores: "strain/µm/m", "gauge_1_kN".
    for (const std::size_t at : {cell.find('/'), cell.rfind('/'), cell.rfind('_')})
        if (at != npos && isUnitBehind(cell.substr(0, at), cell.substr(at + 1)))
            return parts(cell.substr(0, at), cell.substr(at + 1));
    return parts(cell, {});
}

bool isTimeName(std::string_view name) {
    const std::string lower = lowerCase(std::string(name));
    const std::string_view beginnings[] = {"time",   "zeit",      "tid",         "x_value", "x-axis",
                                           "x axis", "timestamp", "zeitstempel", "t(",      "t [",
                                           "t_",     "elapsed",   "date",        "datum"};
    return lower == "t" || lower == "x" || std::ranges::any_of(beginnings, [&](std::string_view beginning) {
               return lower.starts_with(beginning);
           });
}

}  // namespace drillwave
