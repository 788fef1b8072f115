// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn of the needs of the thrust along a parameter.
#pragma once

#include <QPointF>
#include <QString>
#include <QVector>
#include <array>
#include <optional>

#include "core/report/thrust_csv.h"
#include "ui/plot/graph_data.h"

namespace drillwave {

/// Of values in SI.
struct ThrustUnits {
    ShownUnit along;      ///< the parameter
    ShownUnit force;      ///< thrusts
    ShownUnit length;     ///< gaps
    ShownUnit frequency;  ///< of blows
    bool operator==(const ThrustUnits&) const = default;
};

/// Curves over the parameter, in the units of `units`.
struct ThrustPicture {
    struct Need {
        GraphData fullRate;  ///< f I0 (1+e)
        GraphData returned;  ///< f I0 (1+2e)
        bool known = false;  ///< it can be told: of a drill string not all can
    };

    ThrustUnits units;
    QString along;  ///< name of the parameter
    std::string key;
    bool isLogarithmic = false;
    double from = 0;  ///< ends of the parameter, from < to
    double to = 1;
    std::array<Need, thrustCaseCount> needs;  ///< in the order of ThrustCase
    QVector<QPointF> balance;                 ///< f I0
    QVector<QPointF> fullRate;                ///< of this blow
    QVector<QPointF> returned;                ///< likewise
    QVector<QPointF> resting;                 ///< f I0 (1+e)/(1−e), may be infinite
    QVector<QPointF> feed;                    ///< the effective force; empty where no thrust is installed
    bool isWeighted = false;                  ///< it is not the thrust alone
};

ThrustPicture thrustPicture(const ThrustAlong& along, const ThrustUnits& units);

/// Those in which the scenario is shown, which must have a thrust, with `along` for the parameter.
ThrustUnits thrustUnits(const Scenario& scenario, const Unit& along, const ShownUnits& units);

/// "this blow", "95 % of all gaps", "rigid rock", "elastic rock, worst gap".
QString thrustCaseName(ThrustCase which);

}  // namespace drillwave
