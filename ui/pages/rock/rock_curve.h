// SPDX-License-Identifier: GPL-3.0-or-later
// The path of a blow in the force–penetration plane, and its characteristic numbers.
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

/// Straight line of the loading curve that a blow has followed.
struct RockLine {
    QPointF from, to;  ///< ends of the line: penetration as x, force as y, in the units shown
    double slope = 1;  ///< slope as a multiple of the stiffness k
    bool operator==(const RockLine&) const = default;
};

/// Force–penetration path of a blow, in the units of `units`. It is computed outside the window's thread and
/// never changed.
struct RockCurve {
    using Path = QSharedPointer<QCPDataContainer<QCPCurveData>>;

    ShownUnits units;
    Path path;  ///< force over penetration; the curve parameter is the global time
    /// Path to draw and fill: `path` with a limited number of points.
    Path outline;
    double peakForce = 0;            ///< largest impact force Fm, in units.force
    double maxPenetration = 0;       ///< largest penetration Um, in units.penetration
    double residualPenetration = 0;  ///< residual penetration Ur, in units.penetration
    double loading = 0;              ///< stiffness k in primary loading, in units.stiffness
    double unloading = 0;            ///< stiffness k/γ in unloading, in units.stiffness
    /// Straight lines of the loading curve up to the largest force; a single one for a law without corners.
    QVector<RockLine> lines = {};
    double energy = 0;       ///< energy left in the rock (the enclosed area), in units.energy
    double energyShare = 0;  ///< energy left in the rock as a share of the energy of the blow, 0 … 1
    std::vector<RunOverlay<RockCurve>> runs = {};  ///< paths of pinned runs (results kept for comparison)
};

/// Returns the path of a solved blow; empty if it was solved without time histories. Penetration is computed
/// from the force by ContactLaw::penetration(). While bit and rock are apart, it stays at the remaining
/// penetration of the rock.
RockCurve rockCurve(const Blow& blow, const ShownUnits& units);

/// Returns penetration (x) and force (y) at a time of the blow, in the units shown. Times before or after the
/// path give its first or last point.
QPointF rockPoint(const RockCurve& curve, double time);

}  // namespace drillwave
