// SPDX-License-Identifier: GPL-3.0-or-later
// Draws any figure that is data, on screen and in files alike.
#pragma once

#include <functional>
#include <vector>

#include "core/report/figure.h"
#include "ui/plot/curve_marks.h"
#include "ui/plot/drag_line.h"
#include "ui/plot/figure_bands.h"
#include "ui/plot/layer_items.h"
#include "ui/plot/series_drag.h"
#include "ui/plot/study_frame.h"
#include "ui/text/shown_units.h"

namespace drillwave {

class PlotWidget;

/// The units of one reader: of multiples of the blow's quantities and of SI values, and of fields.
struct FigureUnits {
    ShownUnits units;
    std::function<const Unit&(const Parameter&)> unitFor;

    /// shown value = value of the figure times factor.
    ShownUnit of(const FigureQuantity& quantity) const;
};

struct ShownFigure {
    StudyFigure figure;
    FigureUnits units;
};

/// All of a figure is in view when it is fitted. A figure may have other panels than the one before only
/// after those that they share, each in a row of its own.
class FigureFrame : public StudyFrame {
    Q_OBJECT

  public:
    explicit FigureFrame(QCustomPlot* plot);

    /// Shows the figure; the view stays where it is unless it was fitted, or the axes have become others.
    void present(const ShownFigure& shown);
    /// Nothing before the first figure, and while there are words in its place.
    bool isEmpty() const { return m_panels.empty() || m_isCleared; }
    /// A series of a panel that is a line; requires that there is one.
    QCPGraph* graph(std::size_t panel = 0, std::size_t series = 0) const;
    /// Returns the panel with that rect.
    std::optional<std::size_t> panelIn(const QCPAxisRect* rect) const;
    /// Shows marks of pinned runs in another panel than the first.
    void setRunsIn(std::size_t panel, const QVector<RunMark>& marks);
    const QVector<RunMark>& runMarksIn(std::size_t panel) const { return m_panels.at(panel).runs->marks(); }
    /// The target of clicks in a rect; nullptr where a click sets nothing.
    const AxisTarget* targetIn(const QCPAxisRect* rect) const;
    /// Over the shown values of the first panel.
    const ShownUnit& xUnit() const { return m_xUnit; }
    const ShownUnit& yUnit() const { return m_yUnit; }
    /// Over the shown values of another panel.
    ShownUnit yUnitOf(std::size_t panel) const {
        return m_shown.units.of(panelOf(m_panels[panel].first).y.quantity);
    }
    /// The line that can be dragged.
    const SeriesDrag& seriesDrag() const { return *m_seriesDrag; }
    /// The value that dragging it sets; nullptr where no line can be dragged.
    const AxisTarget* dragged() const;
    /// Tells the plot what its lines stand for, with the function behind the points of the figure's own.
    void giveMeanings(PlotWidget& plot) const;
    /// Along the lines of the first panel, to its marks; from point to point where points are marked.
    KeyPlaces keyPlaces() const override;
    /// Returns the row of the study's table whose point is nearest to a place of the first panel, within a
    /// few pixels.
    std::optional<std::size_t> rowAt(QPointF place) const;

  signals:
    /// The user moves the line of a figure's handle, and lets it go; in values of the figure.
    void handleMoved(double x);
    void handleReleased(double x);
    /// The user has taken hold of the line of dragged(), and moves it there; in values of the figure.
    void seriesHeld(double y);
    void seriesMoved(double y);

  private:
    /// A series as it is drawn: a line or a path.
    struct Drawn {
        QCPGraph* line = nullptr;
        QCPCurve* path = nullptr;
        QCPGraph* upper = nullptr;          // of a strip
        std::vector<QCPItemText*> texts{};  // beside the points
        QCPAbstractPlottable* plottable() const {
            return line ? static_cast<QCPAbstractPlottable*>(line) : path;
        }
        void clear() const;  // of its data
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
        DragLine* handle = nullptr;
        RunMarks* runs = nullptr;
        std::size_t first = 0;  // panel with its y axis
        std::size_t last = 0;   // panel with its y axis
    };

    void clear() override;
    void restyle() override;
    void setRanges() override;
    void build();
    void addPanels();
    void showPanel(std::size_t index);
    void addPanel(std::size_t index, QCPLayoutGrid& row);
    void addHandle(std::size_t index);
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
    void styleLine(const Panel& panel, std::size_t index, const FigureSeries& series) const;
    QString numberOf(const FigureNumber& number) const;
    QString textOf(const FigureText& text) const;
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
    /// An empty one where an earlier figure had more.
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

}  // namespace drillwave
