// SPDX-License-Identifier: GPL-3.0-or-later
// The path of a blow in the force–penetration plane and the numbers that mark it.
#pragma once

#include <QPointF>
#include <QSharedPointer>
#include <QVector>

#include "core/blow/blow.h"
#include "ui/runs/run_overlay.h"
#include "ui/text/shown_units.h"

class QCPCurveData;
template <class DataType>
class QCPDataContainer;

namespace drillwave {

/// A part of the loading curve that the blow has gone along.
struct RockLine {
    QPointF from, to;  ///< penetration, force
    double slope = 1;  ///< of the stiffness k
    bool operator==(const RockLine&) const = default;
};

/// All in the units of `units`; built away from the window's thread, never changed once built.
struct RockCurve {
    using Path = QSharedPointer<QCPDataContainer<QCPCurveData>>;

    ShownUnits units;
    Path path;  ///< penetration, force; the parameter t is the global time
    /// The path as drawn and filled, with a limited number of points.
    Path outline;
    double peakForce = 0;                          ///< Fm
    double maxPenetration = 0;                     ///< Um
    double residualPenetration = 0;                ///< Ur
    double loading = 0;                            ///< k
    double unloading = 0;                          ///< k/γ
    QVector<RockLine> lines = {};                  ///< up to the peak; one without corners
    double energy = 0;                             ///< left in the rock: the enclosed area
    double energyShare = 0;                        ///< of the hammer work
    bool ofHammerEnergy = false;                   ///< of a hammer: the share is that of its energy E0
    std::vector<RunOverlay<RockCurve>> runs = {};  ///< laid over it
};

/// Returns the path of a solved blow, empty without histories. Penetration follows from the force only by
/// ContactLaw::penetration(); while bit and rock are apart, it is the remaining penetration.
RockCurve rockCurve(const Blow& blow, const ShownUnits& units);

/// Returns penetration and force at a global time in shown units; the ends of the path before and after it.
QPointF rockPoint(const RockCurve& curve, double time);

}  // namespace drillwave
