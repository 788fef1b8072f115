// SPDX-License-Identifier: GPL-3.0-or-later
// Data of the plots of many blows and of a scan of them, in the units shown.
#pragma once

#include <QPointF>
#include <QString>
#include <QVector>
#include <optional>

#include "core/study/drilling/drilling_study.h"
#include "core/study/scan/drilling_scan.h"
#include "ui/plot/graph_data.h"

namespace drillwave {

/// Units of the plots of many blows: shown value = SI value · factor.
struct DrillingShown {
    ShownUnit length;  ///< gaps and penetrations
    ShownUnit rate;    ///< penetration rate
    ShownUnit along;   ///< scanned parameter
    bool operator==(const DrillingShown&) const = default;
};

/// Returns the units for a scenario with drill data; `along` is the unit of the scanned parameter.
DrillingShown drillingShown(const Scenario& scenario, const Unit& along, const ShownUnits& units);

/// Gap and penetration of each blow over the number of the blow, which starts at 1.
struct BlowPoints {
    QVector<QPointF> gaps, penetrations;
};

/// Data of the plots of one blow sequence. While it is being computed, the results known only at its end are
/// empty.
struct MarchPicture {
    BlowPoints now;
    /// Number of blows that the sequence will have, and number of transient blows at its start.
    long blows = 0, settle = 0;
    std::vector<double> parts;  ///< share [%] of the counted blows in each part of a period of the gap
    QVector<QPointF> cor;       ///< coefficient of restitution over the gap divided by its period (0 … 1)
    /// Gap of each counted blow over the gap of the blow before, in the unit shown.
    QVector<QPointF> returns;
    QVector<QPointF> lastReturns;  ///< the last of `returns`, in their order
    /// Share of the energy that went to one place.
    struct Share {
        QString name;
        double share;  ///< share (0 … 1) of the energy supplied by hammer and feed
    };
    QVector<Share> energy;
    QString summary;
};

/// Returns the data of the plots of a blow sequence with these settings. `blows` may be incomplete; `result`
/// is nullptr until the sequence is complete.
MarchPicture marchPicture(const std::vector<DrillingBlow>& blows, const DrillingSettings& settings,
                          const DrillingUnits& units, const DrillingResult* result,
                          const QVector<QPointF>& corOverGap, const DrillingShown& shown);
/// Returns gap and penetration of each blow.
BlowPoints blowPoints(const std::vector<DrillingBlow>& blows, const DrillingUnits& units,
                      const DrillingShown& shown);

/// Curves of one scan over a parameter. Several scans can be drawn over each other.
struct ScanCurve {
    /// Penetration rate of sequences that start at rest, with the limits of its 95 % error, in the unit
    /// shown.
    QVector<QCPGraphData> rate, low, high;
    QVector<QCPGraphData> contactShare;  ///< contact share: blows that start on the rock [%]
    /// Penetration rate of sequences that start bouncing, where these give another motion.
    QVector<QCPGraphData> otherRate;
    QVector<QCPGraphData> gaps, otherGaps;  ///< gaps of all counted blows in the unit shown, for both starts
};

/// Data of the plots of a scan over a parameter.
struct ScanPicture {
    /// Name of the scanned parameter.
    QString along;
    bool isLogarithmic = false;
    /// Ends of the scanned range, in the unit shown.
    double from = 0, to = 1;
    ScanCurve scan;
    /// Penetration rates with a constant feed force and with a strong damper; empty if not wanted.
    QVector<QCPGraphData> constantForce, strongDamper;
    struct Mark {
        double at;
        QString words;
    };
    /// Feed forces f I0, f I0 (1 + e) and f I0 (1 + 2e); empty if another parameter is scanned.
    QVector<Mark> marks;
};

/// Returns the data of the plots of a scan. `constantForce` and `strongDamper` may be nullptr. Requires a
/// scan with at least one point.
ScanPicture scanPicture(const DrillingScan& scan, const DrillingScan* constantForce,
                        const DrillingScan* strongDamper, const DrillingShown& shown);

/// Contents of the plot: a blow sequence, a scan, or both.
struct DrillingPicture {
    QString message = {};  ///< reason why there is nothing to show; if not empty, it is shown instead
    DrillingShown units;
    std::optional<MarchPicture> march;
    BlowPoints before;  ///< blows of an earlier scenario, shown faintly
    std::optional<ScanPicture> scan;
    bool isScanOld = false;  ///< whether the scan belongs to an earlier scenario
    /// Present value of the scanned parameter, in the unit shown; empty if it has none.
    std::optional<double> installed = {};
};

}  // namespace drillwave
