// SPDX-License-Identifier: GPL-3.0-or-later
// The loading lines of a law with corners, named on the path of a blow.
#pragma once

#include <qcustomplot.h>

#include <QLocale>
#include <QObject>
#include <QVector>

#include "ui/pages/rock/rock_curve.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// Marks the corners that a blow has passed, and names the following lines by their slopes as multiples of k.
/// Lives as a child of the plot.
class LoadingLines : public QObject {
    Q_OBJECT

  public:
    explicit LoadingLines(QCPAxisRect* rect);

    /// Shows the lines after the first, which has its own name; too many lines are marked without names.
    void present(const QVector<RockLine>& lines, const QLocale& locale);
    /// Names along their lines, at any zoom.
    void place();
    void setStyle(const PlotStyle& style);
    /// The names, "0.35 k".
    QStringList texts() const;

  private:
    QCPAxisRect* m_rect;
    QVector<RockLine> m_lines;
    QVector<QCPItemText*> m_names;
    QVector<QCPItemTracer*> m_corners;
    PlotStyle m_style = PlotStyle::forPaper();
};

/// Degrees, clockwise, by which text follows a line between two pixels.
double rotationAlong(const QPointF& from, const QPointF& to);

}  // namespace drillwave
