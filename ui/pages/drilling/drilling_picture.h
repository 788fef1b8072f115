// SPDX-License-Identifier: GPL-3.0-or-later
// Picture of many blows and of a scan of them, in the units on show.
#pragma once

#include <QPointF>
#include <QString>
#include <QVector>
#include <optional>

#include "core/study/drilling/drilling_study.h"
#include "core/study/scan/drilling_scan.h"
#include "ui/plot/graph_data.h"

namespace drillwave {

/// Units of the picture, for values in SI.
struct DrillingShown {
    ShownUnit length;  ///< gaps and penetrations
    ShownUnit rate;    ///< of penetration
    ShownUnit along;   ///< what is scanned
    bool operator==(const DrillingShown&) const = default;
};

/// Returns the units for a scenario that has a drill, with `along` for the parameter that is scanned.
DrillingShown drillingShown(const Scenario& scenario, const Unit& along, const ShownUnits& units);

/// Points over the number of a blow, which begins with 1.
struct BlowPoints {
    QVector<QPointF> gaps, penetrations;
};

/// A march; while it grows without what is known at its end.
struct MarchPicture {
    BlowPoints now;
    long blows = 0, settle = 0;
    std::vector<double> parts;     ///< share of the blows in each part of a period of the gap
    QVector<QPointF> cor;          ///< e over the gap in its period
    QVector<QPointF> returns;      ///< gap over the one before
    QVector<QPointF> lastReturns;  ///< of the last of them, in their order
    struct Share {
        QString name;
        double share;  ///< of what hammer and feed gave
    };
    QVector<Share> energy;
    QString summary;
};

/// `blows` are of a march with those settings; `result` is nullptr until it is complete.
MarchPicture marchPicture(const std::vector<DrillingBlow>& blows, const DrillingSettings& settings,
                          const DrillingUnits& units, const DrillingResult* result,
                          const QVector<QPointF>& corOverGap, const DrillingShown& shown);
/// Returns only gaps and penetrations.
BlowPoints blowPoints(const std::vector<DrillingBlow>& blows, const DrillingUnits& units,
                      const DrillingShown& shown);

/// One scan of several that are laid over each other.
struct ScanCurve {
    QVector<QCPGraphData> rate, low, high;  ///< from rest, with 95 % errors
    QVector<QCPGraphData> contactShare;     ///< of the blows
    QVector<QCPGraphData> otherRate;        ///< from bouncing, where that is another motion
    QVector<QCPGraphData> gaps, otherGaps;  ///< of every blow that counts
};

struct ScanPicture {
    QString along;
    bool isLogarithmic = false;
    double from = 0, to = 1;
    ScanCurve scan;
    QVector<QCPGraphData> constantForce, strongDamper;  ///< rates; empty where they were not wanted
    struct Mark {
        double at;
        QString words;
    };
    QVector<Mark> marks;  ///< of the thrust: f I0, f I0 (1 + e), f I0 (1 + 2e)
};

/// Requires points.
ScanPicture scanPicture(const DrillingScan& scan, const DrillingScan* constantForce,
                        const DrillingScan* strongDamper, const DrillingShown& shown);

/// Content of the plot; either may be missing.
struct DrillingPicture {
    QString message = {};  ///< shown instead of all else: why there is nothing to show
    DrillingShown units;
    std::optional<MarchPicture> march;
    BlowPoints before;  ///< of an earlier scenario, faintly
    std::optional<ScanPicture> scan;
    bool isScanOld = false;                ///< it is of an earlier scenario
    std::optional<double> installed = {};  ///< where the scenario is along the scan
};

}  // namespace drillwave
