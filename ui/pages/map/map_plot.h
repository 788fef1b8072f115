// SPDX-License-Identifier: GPL-3.0-or-later
// A map with its colours, contours and cuts: the same drawing code for the page and for files.
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <memory>
#include <optional>

#include "ui/pages/map/map_picture.h"
#include "ui/pages/map/map_raster.h"
#include "ui/pages/study/run_marks.h"
#include "ui/plot/fitted_view.h"
#include "ui/plot/key_point.h"
#include "ui/plot/plot_message.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

class MapContours;
class MapCrosshair;
class MapPresets;

/// Colours over two parameters with a bar, lines where contours are, and through the crosshair a cut below
/// and one beside. Lives as a child of the plot.
class MapPlot : public QObject {
    Q_OBJECT

  public:
    explicit MapPlot(QCustomPlot* plot);
    ~MapPlot() override;

    /// Shows a map; the view stays where it is unless it was fitted, or parameters, ranges or units changed.
    void present(const MapPicture& picture);
    /// No map, and `message` in its place (why there is none).
    void showNothing(const QString& message);
    /// Where the present scenario is, in shown units: at first that of the map.
    void setHere(const std::optional<QPointF>& place);
    /// Where pinned runs are, in shown units.
    void setRuns(const QVector<RunMark>& marks);
    const QVector<RunMark>& runs() const { return m_runs->marks(); }
    void setStyle(const PlotStyle& style);
    /// The whole map in view.
    void fit();

    const std::optional<MapPicture>& picture() const { return m_picture; }
    MapCrosshair* crosshair() const { return m_crosshair; }
    /// Whether that is the map, and not a cut or the bar.
    bool isMap(const QCPAxisRect* rect) const { return rect == m_map; }
    QCPAxisRect* mapRect() const { return m_map; }
    QCPGraph* cutAlongX() const { return m_alongX; }
    /// The point of the map nearest to a place in shown units; nullopt outside.
    std::optional<MapGrid::Place> pointAt(QPointF shown) const;
    /// What is below a pixel, in words: both parameters, and the value or why there is none. Empty outside.
    QString readout(QPointF pixel) const;
    /// Where keys may go: anywhere on the map, to the presets.
    KeyPlaces keyPlaces() const;
    /// What the plot shows, in words, for assistive tools and the line above it.
    QString textSummary() const { return m_summary; }

  private:
    void addRects();
    void addCuts();
    void linkAxes();
    void showCuts();
    /// By the points they go through; false where they are called so already.
    bool nameCuts();
    void setLabels();
    QString summary() const;

    QCustomPlot* m_plot;
    QCPAxisRect* m_map = nullptr;
    QCPAxisRect* m_below = nullptr;
    QCPAxisRect* m_beside = nullptr;
    QCPColorScale* m_bar = nullptr;
    MapRaster* m_raster = nullptr;
    QCPGraph* m_alongX = nullptr;
    QCPCurve* m_alongY = nullptr;
    std::unique_ptr<MapContours> m_contours;
    std::unique_ptr<MapPresets> m_presets;
    MapCrosshair* m_crosshair = nullptr;
    RunMarks* m_runs = nullptr;
    PlotMessage* m_message;
    std::optional<MapPicture> m_picture;
    std::optional<MapGrid::Place> m_cut;  // through which point the cuts are
    PlotStyle m_style;
    FittedView* m_view;
    QString m_summary;
};

}  // namespace drillwave
