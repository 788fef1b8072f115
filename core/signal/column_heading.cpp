// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/column_heading.h"

#include <optional>
#include <utility>

#include "core/signal/signal_unit.h"
#include "core/text/decimal_text.h"
#include "core/text/lower_case.h"
#include "core/text/units.h"

namespace drillwave {
namespace {

bool isTimeUnit(std::string_view word) {
    return findUnit(Quantity::time, word) && word != "min";  // a minimum
}

/// Whether a last word without brackets is a unit, and no word of the name: "strain", "ε".
bool isUnitWord(std::string_view word) {
    if (isTimeUnit(word)) return true;
    const std::optional<NamedSignalUnit> found = findSignalUnit(word);
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

TableColumn columnOf(std::string_view heading) {
    constexpr auto npos = std::string_view::npos;
    const std::string_view cell = trimmed(heading);
    for (const auto& [open, close] : {std::pair{'[', ']'}, std::pair{'(', ')'}}) {
        const std::size_t at = cell.rfind(open);
        if (at != npos && cell.ends_with(close))
            return parts(cell.substr(0, at), cell.substr(at + 1, cell.size() - at - 2));
    }
    for (const std::string_view word : {" / ", " in "})
        if (const std::size_t at = cell.rfind(word); at != npos)
            return parts(cell.substr(0, at), cell.substr(at + word.size()));
    if (const std::size_t blank = cell.rfind(' '); blank != npos && isUnitWord(cell.substr(blank + 1)))
        return parts(cell.substr(0, blank), cell.substr(blank + 1));
    // A unit has slashes itself, a name has underscores: "strain/µm/m", "gauge_1_kN".
    for (const std::size_t at : {cell.find('/'), cell.rfind('_')})
        if (at != npos && isUnitBehind(cell.substr(0, at), cell.substr(at + 1)))
            return parts(cell.substr(0, at), cell.substr(at + 1));
    return parts(cell, {});
}

bool isTimeName(std::string_view name) {
    const std::string lower = lowerCase(std::string(name));
    return lower == "t" || lower.starts_with("time") || lower.starts_with("zeit") ||
           lower.starts_with("x_value");
}

}  // namespace drillwave
