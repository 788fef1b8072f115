// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/figure_units.h"

#include <algorithm>

namespace drillwave {
namespace {

template <class... Each>
struct Visitor : Each... {
    using Each::operator()...;
};

/// Units of multiples of the scales of a blow, in the order of BlowScale.
constexpr ShownUnit ShownUnits::*scaleUnits[] = {
    &ShownUnits::time,        &ShownUnits::force,     &ShownUnits::impulse,
    &ShownUnits::penetration, &ShownUnits::stiffness, &ShownUnits::energy,
    &ShownUnits::stress,      &ShownUnits::length,    &ShownUnits::velocity};

}  // namespace

ShownUnit FigureUnits::of(const FigureQuantity& quantity) const {
    return std::visit(
        Visitor{[](PlainNumber plain) {
                    return plain == PlainNumber::percent ? ShownUnit{1, QStringLiteral("%")} : ShownUnit{};
                },
                [&](BlowScale scale) { return units.*scaleUnits[static_cast<std::size_t>(scale)]; },
                [&](const SiValues& si) {
                    const auto row = std::ranges::find_if(unitKinds(), [&](const UnitKindRow& each) {
                        return each.quantity == si.quantity && (si.kind.empty() || each.name == si.kind);
                    });
                    return row == unitKinds().end() ? ShownUnit{} : units.of(row->kind, si.size);
                },
                [&](const KeptParameter& parameter) { return shownUnit(unitFor(*parameter)); }},
        quantity);
}

}  // namespace drillwave
