// SPDX-License-Identifier: GPL-3.0-or-later
// A measured force over time, to be laid over a computed one.
#pragma once

#include <string>

#include "core/model/table_points.h"

namespace drillwave {

enum class MeasuredQuantity {
    normalForce,  ///< N in a section of the rod or string, tension positive
    impactForce,  ///< F on the rock, compression positive
};

struct MeasuredSignal {
    std::string name;
    MeasuredQuantity quantity = MeasuredQuantity::normalForce;
    double place = 0;      ///< x from the struck end [m], below 0 in a hammer; of a normal force
    double timeShift = 0;  ///< [s] that is added to the times of the points
    TablePoints points;    ///< time [s], increasing, and force [N]
    double deviation = 0;  ///< of the samples from the lines between the points, at most [N]
    bool operator==(const MeasuredSignal&) const = default;
};

}  // namespace drillwave
