// SPDX-License-Identifier: GPL-3.0-or-later
// The force of the hammer over time as a line to draw, whatever the pulse.
#pragma once

#include <QPolygonF>

#include "core/model/pulse_force.h"

namespace drillwave {

/// Time in t0 from 0 to `end`, force relative to its peak. At most a few thousand points, the extremes of a
/// longer table kept. Pulses without end are shown until little is left of them; empty without a force.
struct PulseCurve {
    QPolygonF points;
    double end = 0;

    explicit PulseCurve(const PulseForce& force);
};

}  // namespace drillwave
