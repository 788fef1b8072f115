// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/identify/option_words.h"

#include <cmath>

#include "core/model/parameter.h"
#include "core/text/decimal_text.h"
#include "core/text/units.h"

namespace drillwave {

namespace {

bool isShare(std::string_view key) {
    return key == "gain" || key == "zero" || key.ends_with("youngs_modulus") || key.ends_with("density");
}

Quantity quantityOf(std::string_view key) {
    return key.ends_with(".area") ? Quantity::area : Quantity::length;
}

std::string inOneWord(double si, Quantity quantity, std::string_view unit) {
    std::string word = formatQuantity(si, quantity, *findUnit(quantity, unit));
    std::erase(word, ' ');
    return word;
}

}  // namespace

ReadWord<GaugeChoice> readGaugeWord(const std::string& word) {
    const std::size_t at = word.rfind('@');
    if (at == std::string::npos || at == 0)
        return {{}, translatable("give COLUMN@DISTANCE, the distance from the bit face"), true};
    GaugeChoice gauge{word.substr(0, at), {}, 0};
    if (const std::size_t plus = gauge.column.find('+'); plus != std::string::npos) {
        gauge.opposite = gauge.column.substr(plus + 1);
        gauge.column.resize(plus);
        if (gauge.column.empty() || gauge.opposite.empty())
            return {{}, translatable("two columns belong around the plus sign"), true};
    }
    const TypedQuantity distance = parseQuantity(word.substr(at + 1), Quantity::length);
    if (!distance.valid()) return {{}, distance.problem};
    if (!(distance.si > 0)) return {{}, translatable("the distance must be positive")};
    gauge.distance = distance.si;
    return {gauge, {}};
}

std::string gaugeWord(const GaugeChoice& gauge) {
    return gauge.name() + "@" + inOneWord(gauge.distance, Quantity::length, "m");
}

ReadWord<KnownTolerance> readKnownWord(const std::string& word, const Scenario& scenario) {
    const std::size_t sign = word.find('=');
    if (sign == std::string::npos || sign == 0) return {{}, translatable("give KEY=+-TOLERANCE"), true};
    KnownTolerance known{word.substr(0, sign)};
    std::string text = word.substr(sign + 1);
    for (const std::string_view prefix : {"+-", "\u00b1", "+/-"})
        if (text.starts_with(prefix)) {
            text.erase(0, prefix.size());
            break;
        }
    if (isShare(known.key) || text.ends_with('%')) {
        const std::optional<double> share = percentageOf(text);
        if (!share) return {{}, translatable("must be a percentage, such as +-2%")};
        known.tolerance = *share;
        if (const KeptParameter parameter = findParameter(known.key);
            !isShare(known.key) && parameter && parameter->applies(scenario))
            known.tolerance *= std::abs(parameter->value(scenario).value_or(0));
    } else {
        const TypedQuantity typed = parseQuantity(text, quantityOf(known.key));
        if (!typed.valid()) return {{}, typed.problem};
        known.tolerance = typed.si;
    }
    if (!(known.tolerance > 0)) return {{}, translatable("the tolerance must be positive")};
    return {known, {}};
}

std::string knownWord(const KnownTolerance& known) {
    const Quantity quantity = quantityOf(known.key);
    return known.key + "=+-" +
           (isShare(known.key)
                ? formatNumber(100 * known.tolerance) + "%"
                : inOneWord(known.tolerance, quantity, quantity == Quantity::area ? "mm^2" : "mm"));
}

std::optional<double> percentageOf(std::string_view text) {
    if (!text.ends_with('%')) return std::nullopt;
    const std::optional<double> number = parseNumber(text.substr(0, text.size() - 1));
    return number ? std::optional(*number / 100) : std::nullopt;
}

}  // namespace drillwave
