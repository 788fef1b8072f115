// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/figure_units.h"

#include <algorithm>

namespace drillwave {
namespace {

template <class... Each>
struct Visitor : Each... {
    using Each::operator()...;
};

const ShownUnit& unitOf(BlowScale scale, const ShownUnits& units) {
    switch (scale) {
        case BlowScale::time:
            return units.time;
        case BlowScale::force:
            return units.force;
        case BlowScale::impulse:
            return units.impulse;
        case BlowScale::penetration:
            return units.penetration;
        case BlowScale::stiffness:
            return units.stiffness;
        case BlowScale::energy:
            return units.energy;
        case BlowScale::stress:
            return units.stress;
        case BlowScale::length:
            return units.length;
        case BlowScale::velocity:
            break;
    }
    return units.velocity;
}

}  // namespace

ShownUnit FigureUnits::of(const FigureQuantity& quantity) const {
    return std::visit(
        Visitor{[](PlainNumber plain) {
                    return plain == PlainNumber::percent ? ShownUnit{1, QStringLiteral("%")} : ShownUnit{};
                },
                [&](BlowScale scale) { return unitOf(scale, units); },
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
