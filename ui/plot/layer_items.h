// SPDX-License-Identifier: GPL-3.0-or-later
// Layers of a figure: shaded areas between curves, each with its name.
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <QVector>
#include <vector>

#include "core/report/figure.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// Shaded areas behind the curves of an axis rect, clipped at its axes in every file format. The plot owns
/// the object.
class LayerItems : public QObject {
    Q_OBJECT

  public:
    explicit LayerItems(QCPAxisRect* rect);

    /// Shows the shaded layers of a figure, which lie one above the other between curves over x. A coordinate
    /// of a layer times `xFactor` or `yFactor` is a value on the axis.
    void present(const FigureLayers& layers, double xFactor, double yFactor);
    void setStyle(const PlotStyle& style);

  private:
    struct Item {
        QCPCurve* area;
        QCPItemText* name;
    };

    void addLayer();
    void place();
    QVector<QPointF> edge(std::size_t above, double level) const;
    void placeName(QCPItemText& name, const QVector<QPointF>& floor, const QVector<QPointF>& ceiling);
    bool hasRoom(const QCPItemText& name, QPointF floor, QPointF ceiling) const;

    QCPAxis* m_x;
    QCPAxis* m_y;
    FigureLayers m_layers;  // layers in the units of the axes
    PlotStyle m_style;
    std::vector<Item> m_items;
};

}  // namespace drillwave
