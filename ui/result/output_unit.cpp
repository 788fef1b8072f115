// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/result/output_unit.h"

namespace drillwave {

ShownUnit outputUnit(const Output& output, const ShownUnits& units, double size) {
    switch (output.measure) {
        case Measure::number:
        case Measure::error:
        case Measure::work:
        case Measure::share:
            return {};
        case Measure::time:
            return units.time;
        case Measure::impulse:
            return units.impulse;
        case Measure::force:
            return units.force;
        case Measure::penetration:
            return units.penetration;
        case Measure::stress:
            return units.stress;
        case Measure::newton:
            return units.of(UnitKind::force, size);
        case Measure::watt:
            return units.of(UnitKind::power, size);
        case Measure::speed:
            return units.of(UnitKind::rate, size);
    }
    return {};
}

}  // namespace drillwave
