// SPDX-License-Identifier: GPL-3.0-or-later
// The presets along the range of a study.
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <QVector>
#include <span>

#include "ui/pages/curve/curve_picture.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// Bands over the whole height of an axis rect, if they are in view, with their names at its foot: in two
/// rows, clear of each other; a name that fits in neither is left out. Lives as a child of the plot.
class PresetBands : public QObject {
    Q_OBJECT

  public:
    explicit PresetBands(QCPAxisRect* rect);

    /// Replaces the bands.
    void present(const QVector<PresetBand>& bands);
    void setStyle(const PlotStyle& style);

  private:
    struct Drawn {
        PresetBand band;
        QCPItemRect* area;
        QCPItemText* name;
    };
    void prepare(QCPAbstractItem& item, const QString& layer);
    void place();
    void placeName(const Drawn& drawn, std::span<double> taken) const;
    void applyStyle();

    QCPAxisRect* m_rect;
    QVector<Drawn> m_drawn;  // from the left
    PlotStyle m_style;
};

}  // namespace drillwave
