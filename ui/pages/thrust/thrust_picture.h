// SPDX-License-Identifier: GPL-3.0-or-later
// Picture of the required feed force along a parameter.
#pragma once

#include <QPointF>
#include <QString>
#include <QVector>
#include <array>
#include <optional>

#include "core/report/thrust_report.h"
#include "ui/plot/graph_data.h"

namespace drillwave {

/// Values in SI.
struct ThrustUnits {
    ShownUnit along;      ///< the parameter
    ShownUnit force;      ///< thrusts
    ShownUnit frequency;  ///< of blows
    bool operator==(const ThrustUnits&) const = default;
};

/// Curves over the parameter, in the units of `units`.
struct ThrustPicture {
    struct Need {
        GraphData required;      ///< f I0 (1+e)
        GraphData returnInTime;  ///< f I0 (1+2e)
        bool known = false;      ///< it is computed: of a drill string not all are
    };

    ThrustUnits units;
    QString along;  ///< name of the parameter
    std::string key;
    bool isLogarithmic = false;
    double from = 0;  ///< ends of the parameter, from < to
    double to = 1;
    std::array<Need, thrustCaseCount> needs;  ///< in the order of ThrustCase
    QVector<QPointF> balance;                 ///< f I0
    QVector<QPointF> ofThisBlow;              ///< f I0 (1+e)
    QVector<QPointF> largest;                 ///< f I0 (1+e) of the largest known case
    QVector<QPointF> largestReturn;           ///< f I0 (1+2e) of the largest need
    QVector<QPointF> feed;                    ///< the effective force; empty where no thrust is installed
    bool isWeighted = false;                  ///< whether the weight is added to the thrust
};

ThrustPicture thrustPicture(const ThrustAlong& along, const ThrustUnits& units);

/// Returns the units of a scenario that has a feed force, with `along` for the parameter.
ThrustUnits thrustUnits(const Scenario& scenario, const Unit& along, const ShownUnits& units);

}  // namespace drillwave
