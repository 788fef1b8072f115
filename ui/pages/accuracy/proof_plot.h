// SPDX-License-Identifier: GPL-3.0-or-later
// Proofs as points on two logarithmic axes: error against run time, extreme cases against their marks.
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <optional>

#include "ui/pages/accuracy/proof_picture.h"
#include "ui/plot/fitted_view.h"
#include "ui/plot/key_point.h"
#include "ui/plot/plot_message.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// Draws a picture of proofs, on screen and in files alike. Lives as a child of the plot.
class ProofPlot : public QObject {
    Q_OBJECT

  public:
    explicit ProofPlot(QCustomPlot* plot);

    /// Shows the picture; the view stays where it is unless it was fitted or the axes are others.
    void present(const ProofPicture& picture);
    /// No points, and `message` in their place.
    void showNothing(const QString& message);
    void setStyle(const PlotStyle& style);
    /// All points in view.
    void fit();
    /// The row of the study whose point is nearest to a pixel, if one is near.
    std::optional<int> rowAt(QPointF pixel) const;
    /// Where keys may go: from point to point; `nameOf` says what a row of the study is.
    KeyPlaces keyPlaces(std::function<QString(int)> nameOf) const;

  private:
    void clear();
    void addSeries(const ProofSeries& series, int index);
    void placeLabels();
    void applyStyle();
    void setNumbersVisible(bool visible);

    QCustomPlot* m_plot;
    QCPTextElement* m_caption;
    QVector<QCPGraph*> m_graphs;  // of the series
    QVector<QCPItemText*> m_labels;
    QCPItemStraightLine* m_mark;
    QCPItemText* m_markName;
    PlotMessage* m_message;
    ProofPicture m_picture;
    PlotStyle m_style;
    FittedView* m_view;
};

}  // namespace drillwave
