// SPDX-License-Identifier: GPL-3.0-or-later
// Draws a figure given as data, in the same way on screen and in files.
#pragma once

#include <vector>

#include "core/report/figure.h"
#include "ui/plot/curve_marks.h"
#include "ui/plot/drag_line.h"
#include "ui/plot/field_item.h"
#include "ui/plot/figure_bands.h"
#include "ui/plot/figure_units.h"
#include "ui/plot/layer_items.h"
#include "ui/plot/series_drag.h"
#include "ui/plot/study_frame.h"

namespace drillwave {

class PlotWidget;

/// Figure of a study, with the units in which the plot shows it.
struct ShownFigure {
    StudyFigure figure;
    FigureUnits units;
};

/// Plot that draws a figure (StudyFigure) with its panels, curves, bands and texts. A later figure may have
/// more or fewer panels at the end. Panels with the same index must have the same structure in all figures.
class FigureFrame : public StudyFrame {
    Q_OBJECT

  public:
    explicit FigureFrame(QCustomPlot* plot);

    /// Shows a figure. The zoom of the user is kept if the axes are the same as before; otherwise everything
    /// is brought into view.
    void present(const ShownFigure& shown);
    /// Returns whether no figure is visible: before the first call of present(), and while a message is shown
    /// instead.
    bool isEmpty() const { return m_panels.empty() || m_isCleared; }
    /// Returns the graph of a series (curve) in a panel; both indices count from 0. The panel and the series
    /// must exist; nullptr if the series is not drawn as a line.
    QCPGraph* graph(std::size_t panel = 0, std::size_t series = 0) const;
    /// Returns the index (from 0) of the panel of the figure whose axes are `rect`; empty if there is none.
    std::optional<std::size_t> panelIn(const QCPAxisRect* rect) const;
    /// Shows the marks of pinned runs (results kept for comparison) in a panel other than the first. For the
    /// first panel (index 0) call setRuns().
    void setRunsIn(std::size_t panel, const QVector<RunMark>& marks);
    const QVector<RunMark>& runMarksIn(std::size_t panel) const { return m_panels.at(panel).runs->marks(); }
    /// Returns the parameter that a click in `rect` sets, with a factor. The parameter is set to factor · x,
    /// where x is the value at the click (SI). nullptr if a click sets nothing.
    const AxisTarget* targetIn(const QCPAxisRect* rect) const;
    /// Values that a click in the first panel sets. They are those of the nearest mark within a few pixels,
    /// else of the nearest line that has a target. Away from both, only x is set.
    struct Target {
        double x = 0;  ///< place of the click or of the mark, in the unit of the axis
        std::optional<SeriesTarget> series = {};  ///< what else the click sets; empty away from lines
        bool isMark = false;
    };
    Target targetAt(QPointF place) const;
    /// Returns the unit in which x is shown in the first panel: shown value = x of the figure · factor.
    const ShownUnit& xUnit() const { return m_xUnit; }
    /// Returns the unit in which y is shown in the first panel: shown value = y of the figure · factor.
    const ShownUnit& yUnit() const { return m_yUnit; }
    /// Returns the unit in which y is shown in a panel: shown value = y of the figure · factor.
    ShownUnit yUnitOf(std::size_t panel) const {
        return m_shown.units.of(panelOf(m_panels[panel].first).y.quantity);
    }
    /// Returns the handler of mouse events that lets the user drag a curve of the first panel up and down.
    const SeriesDrag& seriesDrag() const { return *m_seriesDrag; }
    /// Returns the parameter that the user changes by dragging a curve of the first panel up or down, with
    /// its factor. nullptr if no curve can be dragged.
    const AxisTarget* dragged() const;
    /// Passes the units of the curves to the plot, which needs them for readings and copied data. Curves of
    /// the first panel also get the exact functions y(x) of which they show samples.
    void giveMeanings(PlotWidget& plot) const;
    /// Returns the places of the first panel that the arrow keys reach: points along its curves, or anywhere
    /// in a colour map. If the curves show single points, the keys go from point to point. The key N jumps to
    /// the marks of the panel.
    KeyPlaces keyPlaces() const override;
    /// Returns the row of the study's table that a click at `place` (coordinates of the panel) selects: that
    /// of the nearest point. Nothing if the panel has no rows. Nothing also if no point is within 14 px,
    /// except in a colour map or a panel with hasRowsAlongX.
    std::optional<std::size_t> rowAt(QPointF place, std::size_t panel = 0) const;
    /// Returns the colour map of the first panel of the figure; nullptr if that panel has none.
    const FieldItem* field() const {
        return !isEmpty() && panelOf(0).field ? m_panels.front().field : nullptr;
    }
    /// Returns a description of the point of the first panel's colour map that is nearest to `place`
    /// (coordinates of the axes). It contains x, y, and the value or why there is none. Empty if there is no
    /// map or `place` is outside it.
    QString fieldWords(QPointF place) const;
    const StudyFigure& figure() const { return m_shown.figure; }
    int legendRows() const { return m_legend ? m_legend->rowCount() : 0; }

    /// Returns a text of the figure with its numbers inserted, in the language, number format and units of
    /// the plot.
    QString textOf(const FigureText& text) const;

  signals:
    /// Reports that the user begins to drag the crosshair of the figure.
    void crosshairHeld();
    /// Reports that the user has dragged the crosshair of the figure to a place (coordinates of the axes of
    /// the first panel).
    void crosshairDragged(QPointF place);
    /// Reports that the user is dragging the vertical line of the figure, which is now at x, in the units of
    /// the figure.
    void handleMoved(double x);
    /// Reports that the user has released the draggable vertical line of the figure at x, in the units of the
    /// figure.
    void handleReleased(double x);
    /// Reports that the user begins to drag the curve that can be dragged, see dragged(). `y` is the height
    /// of the pointer in the units of the figure.
    void seriesHeld(double y);
    /// Reports that the user has dragged the curve that can be dragged, see dragged(), to the height `y`, in
    /// the units of the figure.
    void seriesMoved(double y);

  private:
    /// Series (curve or set of points) of a figure with the items that draw it: either a line or a path.
    struct Drawn {
        QCPGraph* line = nullptr;
        HaloPath* path = nullptr;
        QCPGraph* upper = nullptr;          // second edge of a shaded strip
        std::vector<QCPItemText*> texts{};  // labels beside the points
        QCPAbstractPlottable* plottable() const {
            return line ? static_cast<QCPAbstractPlottable*>(line) : path;
        }
        void clear() const;  // removes the data, not the curves
    };
    struct Panel {
        QCPAxisRect* rect = nullptr;
        std::vector<Drawn> series;
        CurveMarks* marks = nullptr;
        QCPItemRect* zone = nullptr;
        QCPItemText* zoneName = nullptr;
        std::vector<QCPItemStraightLine*> levels;
        FigureBands bands{rect};
        LayerItems* layers = nullptr;
        FieldItem* field = nullptr;
        DragLine* handle = nullptr;
        RunMarks* runs = nullptr;
        std::size_t first = 0;  // index of the panel with the y axis of this panel
        std::size_t last = 0;   // index of the last panel with that y axis
    };

    void clear() override;
    void restyle() override;
    void setRanges() override;
    void build();
    void addPanels();
    void showPanel(std::size_t index);
    void addPanel(std::size_t index, QCPLayoutGrid& row, bool begins);
    void addHandle(std::size_t index);
    void addCrosshair();
    void linkAxes(std::size_t begin);
    void addZone(Panel& panel);
    void showSeries(std::size_t index);
    void showAxes(std::size_t index);
    void showBands(std::size_t index);
    void showLevels();
    void showStrip(std::size_t index, std::size_t series);
    void showDrag();
    void followLines();
    void setKeyRange(std::size_t index);
    std::optional<QCPRange> valuesOf(std::size_t first, bool isRight) const;
    void setValueRange(std::size_t first, QCPAxis::AxisType side);
    void styleLine(const Drawn& drawn, std::size_t index, const FigureSeries& series, const QPen& pen) const;
    QString titleOf(const FigureAxis& axis) const;
    QString numberOf(const FigureNumber& number) const;
    void showTexts();
    void placeTexts();
    void breakCaption();
    void placeZones();
    void followTopAxes();
    void setAxesVisible(bool visible);
    bool hasOtherAxes(const ShownFigure& shown) const;
    static bool hasPoints(const StudyPanel& panel);
    bool isThere(std::size_t index) const {
        return index < m_shown.figure.panels.size() && !m_shown.figure.panels[index].isHidden;
    }
    /// Returns the panel with this index (from 0) of the present figure. It is an empty panel if only an
    /// earlier figure had this one.
    const StudyPanel& panelOf(std::size_t index) const;
    bool hasFirstY(std::size_t index) const { return m_panels[index].first == index; }
    QCPAxis* axisOf(std::size_t index, QCPAxis::AxisType side) const {
        return m_panels[index].rect->axis(side);
    }
    double xFactorOf(std::size_t index) const { return m_shown.units.of(panelOf(index).x.quantity).factor; }
    double yFactorOf(std::size_t index) const { return yUnitOf(index).factor; }
    double rightFactorOf(std::size_t index) const {
        return m_shown.units.of(panelOf(index).right.value_or(FigureAxis()).quantity).factor;
    }

    ShownFigure m_shown;
    ShownUnit m_xUnit;
    ShownUnit m_yUnit;
    std::vector<Panel> m_panels;
    std::vector<QCPItemText*> m_levelNames;
    SeriesDrag* m_seriesDrag;
    QString m_captionText;
    bool m_isCleared = true;
};

/// Returns `name` broken into lines at its spaces, so that `count` such names fit side by side below an axis.
QString inLines(const QString& name, std::size_t count);

}  // namespace drillwave
