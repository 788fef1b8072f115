// SPDX-License-Identifier: GPL-3.0-or-later
// The loading lines of a rock law with corners, named on the force–penetration path of a blow.
#pragma once

#include <qcustomplot.h>

#include <QLocale>
#include <QObject>
#include <QVector>

#include "ui/pages/rock/rock_curve.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// Marks at the corners of the loading curve (force over penetration) that a blow has passed. Each line after
/// a corner has a label with its slope, as a multiple of the stiffness k. The plot owns the object.
class LoadingLines : public QObject {
    Q_OBJECT

  public:
    explicit LoadingLines(QCPAxisRect* rect);

    /// Marks where each straight line of the loading curve begins, except the first line, and labels these
    /// lines with their slopes. If there are too many lines, the marks have no labels.
    void present(const QVector<RockLine>& lines, const QLocale& locale);
    /// Places the labels along their lines in the present view.
    void place();
    void setStyle(const PlotStyle& style);
    /// Returns the labels, which are slopes as multiples of the stiffness k, such as "0.35 k".
    QStringList texts() const;

  private:
    QCPAxisRect* m_rect;
    QVector<RockLine> m_lines;
    QVector<QCPItemText*> m_names;
    QVector<QCPItemTracer*> m_corners;
    PlotStyle m_style = PlotStyle::forPaper();
};

/// Returns the angle [degrees, clockwise] at which text follows the line from one pixel to another.
double rotationAlong(const QPointF& from, const QPointF& to);

}  // namespace drillwave
