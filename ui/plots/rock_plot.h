// Impact force against penetration: the enclosed area is the energy left in the rock (paper, Fig. 1).
#pragma once

#include <qcustomplot.h>

#include <QSharedPointer>

#include "core/model/scenario.h"
#include "core/wave/impact.h"
#include "ui/plots/plot_style.h"
#include "ui/shown_units.h"

namespace drillwave {

/// The path of a blow in the force–penetration plane, in the units of `units`.
struct RockCurve {
    ShownUnits units;
    QSharedPointer<QCPCurveDataContainer> path;
};

/// Requires an impact solved with Detail::histories. The penetration follows from the force by the bilinear
/// law alone: U/d0 = (Fm − γ(Fm − F))/(2β), Fm the largest force so far.
RockCurve rockCurve(const Impact& impact, const Groups& groups, const ShownUnits& units);

class RockPlot : public QObject {
    Q_OBJECT

  public:
    explicit RockPlot(QCustomPlot* plot);
    /// Shows the curve with both axes fitted to it.
    void show(const RockCurve& curve);
    void setStyle(const PlotStyle& style);

  private:
    QCustomPlot* m_plot;
    QCPCurve* m_curve;
};

}  // namespace drillwave
