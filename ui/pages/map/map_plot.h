// SPDX-License-Identifier: GPL-3.0-or-later
// A map with its colours, contours and cuts: the same drawing code for the page and for files.
#pragma once

#include <memory>
#include <optional>

#include "ui/pages/map/map_picture.h"
#include "ui/pages/map/map_raster.h"
#include "ui/plot/study_frame.h"

namespace drillwave {

class MapContours;
class MapCrosshair;
class MapPresets;

/// Colours over two parameters with a bar, lines at the contours, and through the crosshair a cut below and
/// one at the side. Fitted, the whole map is in view.
class MapPlot : public StudyFrame {
    Q_OBJECT

  public:
    explicit MapPlot(QCustomPlot* plot);
    ~MapPlot() override;

    /// Shows a map; the view stays where it is unless it was fitted, or parameters, ranges or units changed.
    void present(const MapPicture& picture);
    /// Sets the place of the present scenario, in shown units: at first that of the map.
    void setCrosshair(const std::optional<QPointF>& place);

    const std::optional<MapPicture>& picture() const { return m_picture; }
    MapCrosshair* crosshair() const { return m_crosshair; }
    /// Whether that is the map, and not a cut or the bar.
    bool isMap(const QCPAxisRect* rect) const { return rect == m_rect; }
    QCPAxisRect* mapRect() const { return m_rect; }
    QCPGraph* cutAlongX() const { return m_alongX; }
    /// The point of the map nearest to a place in shown units; nullopt outside.
    std::optional<MapGrid::Place> pointAt(QPointF shown) const;
    /// Describes the point below a pixel: both parameters, and the value or why there is none. Empty outside.
    QString readout(QPointF pixel) const;
    /// Anywhere on the map, to the presets.
    KeyPlaces keyPlaces() const override;

    /// Returns where the output passes the level that decides, or the largest level with a contour; empty of
    /// a map that is not complete, and where it passes none.
    QString answer() const;

  private:
    void clear() override;
    void restyle() override;
    void setRanges() override;
    void addRects();
    void addCuts();
    void linkAxes();
    void showCuts();
    /// Names the cuts by their points; false if they have these names already.
    bool nameCuts();
    void setLabels();
    QString summary() const;

    QCPAxisRect* m_below = nullptr;  // the map, which is in view
    QCPAxisRect* m_beside = nullptr;
    QCPColorScale* m_bar = nullptr;
    MapRaster* m_raster = nullptr;
    QCPGraph* m_alongX = nullptr;
    QCPCurve* m_alongY = nullptr;
    std::unique_ptr<MapContours> m_contours;
    std::unique_ptr<MapPresets> m_presets;
    MapCrosshair* m_crosshair = nullptr;
    std::optional<MapPicture> m_picture;
    std::optional<MapGrid::Place> m_cut;  // through which point the cuts are
};

}  // namespace drillwave
