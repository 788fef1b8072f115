// SPDX-License-Identifier: GPL-3.0-or-later
// A plot on screen: zooms, pans, reads and copies alike on every page, and follows palette, font and screen.
#pragma once

#include <qcustomplot.h>

#include <QByteArray>
#include <QHash>
#include <QPointer>
#include <functional>
#include <optional>

#include "ui/plot/curve_meaning.h"
#include "ui/plot/curve_reading.h"
#include "ui/plot/hover_mark.h"
#include "ui/plot/plot_csv.h"
#include "ui/plot/plot_cursors.h"
#include "ui/plot/plot_rendering.h"
#include "ui/plot/plot_style.h"
#include "ui/plot/view_history.h"

namespace drillwave {

class CursorBar;

/// Mouse: the wheel zooms at the pointer (over an axis only that axis), dragging pans, dragging with Shift or
/// with the right button zooms to a box, a double-click fits, the back button goes back, a click on a legend
/// entry hides or shows its curve, a click on a curve has it read at the cursors; cursors can be dragged.
/// Keys: arrows pan, + and − zoom, Home fits, Backspace or Alt+Left goes back, A, B and T place cursors at
/// the pointer (in the middle when it is elsewhere), Ctrl+Left and Ctrl+Right move the cursor placed last by
/// a pixel, with Shift by ten. The wheel takes the focus; Backspace, A, B and T go to the plot below the
/// pointer wherever the focus is, but in fields for text.
///
/// The curves that are read, hidden and copied are those with an entry in a legend. All axis rects that hold
/// graphs are taken to share one x axis; linking their ranges is up to the page. Every x and y here is in the
/// units of the axes.
class PlotWidget : public QCustomPlot {
    Q_OBJECT

  public:
    using Restyle = std::function<void(const PlotStyle&)>;
    using DataText = std::function<QByteArray(char separator)>;

    explicit PlotWidget(QWidget* parent = nullptr);
    ~PlotWidget() override;

    /// Applies the style of the present palette now, and again whenever palette or font change.
    void followPalette(Restyle restyle);

    /// What a curve of this plot stands for: units for all that is read from it, and where there are such the
    /// exact functions behind its points. Set it again with every result; forgotten with the curve.
    void setMeaning(const QCPAbstractPlottable* curve, CurveMeaning meaning);
    /// The curve has data of its own: reads it again at the cursors. Replots do that by themselves.
    void readCursors();

    /// Puts cursor A, B or the time to x, or takes it away; emits nothing but cursorsRead().
    void placeCursor(PlotCursor cursor, std::optional<double> x);
    void setTimeCursor(std::optional<double> x) { placeCursor(PlotCursor::time, x); }
    std::optional<double> cursorPosition(PlotCursor cursor) const { return m_cursors.position(cursor); }
    /// The graph read at A and B: as chosen, else the first that is visible; nullptr without any.
    QCPGraph* readGraph() const;
    void setReadGraph(QCPGraph* graph);
    /// What cursors A and B say about readGraph(); nothing unless both are placed.
    std::optional<CursorReading> cursorReading() const;
    /// The strip below the plot, in words; empty while neither A nor B is placed.
    QString cursorText() const;
    /// What is marked at the pointer, in words; empty when nothing is.
    QString hoverText() const { return m_hover.text(); }

    void setCurveVisible(QCPAbstractPlottable* curve, bool visible);
    /// Linear or logarithmic; a horizontal axis together with those of all stacked plots.
    void setAxisScale(QCPAxis* axis, QCPAxis::ScaleType scale);
    bool canZoomBack() const { return m_history.canGoBack(); }

    /// The present view drawn for paper, black on white, numbers as in files, with cursors where they are
    /// placed; `format` is one of plotFormats(), `dpi` counts for PNG. See renderPlot().
    QByteArray drawing(const QString& format, Millimetres size, double dpi = standardDpi,
                       const QString& title = {});
    /// The size of the plot on screen at 96 dots per inch.
    Millimetres sizeOnPaper() const;
    /// The data of the plot as CSV; see plotCsv().
    QByteArray csv() const { return dataText(','); }
    /// For a plot whose data are not curves: its text with a separator between cells, as plotCsv() gives it.
    void setDataText(DataText text) { m_dataText = std::move(text); }

    /// Whether what is shown answers the present input; the menu copies and saves nothing else.
    void setCurrent(bool current) { m_current = current; }

    /// The context menu for a point of the plot, built anew; it deletes itself when it is closed.
    QMenu* makeMenu(QPoint at);

    QSize minimumSizeHint() const override { return {300, 240}; }

  public slots:
    /// Keeps the view for zoomBack() and asks the page to fit.
    void fit();
    void zoomBack();
    void copyPicture();
    void copyData();

  signals:
    /// The page is to bring everything into view.
    void fitRequested();
    /// The user moves the time cursor; it is there already. A page that connects this offers the cursor.
    void timeCursorDragged(double x);
    /// Cursor A or B, the curve or its data have changed; see cursorReading().
    void cursorsRead();
    void savePictureRequested();
    void saveDataRequested();

  protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

  private:
    // What the mouse does between press and release.
    enum class Gesture { none, pan, box, cursor };
    struct PannedAxis {
        QPointer<QCPAxis> axis;
        QCPRange start;
    };

    QByteArray dataText(char separator) const;
    void restyle();
    void applyStyle(const PlotStyle& style);
    void followScreen();
    void prepareReplot();
    void placeBar();
    void replotOverlay();

    QList<QCPAxis*> axesAt(QPointF point) const;
    QCPAxisRect* activeRect() const;
    void beginPan(QPointF point);
    void pan(QPointF to);
    void zoomToBox(const QRect& box);
    QCPAxisRect* cursorRect() const;
    void dragCursor(PlotCursor cursor, double pixel);
    void click(QPoint point);
    void hover(QPointF point);
    void showPointer(Qt::CursorShape shape);
    bool cursorKey(const QKeyEvent& event);
    bool viewKey(const QKeyEvent& event);
    void panByKey(int key);
    void zoomByKey(double factor);
    void placeCursorByUser(PlotCursor cursor, std::optional<QPoint> at);
    void moveLastCursor(double pixels);
    void takeCursor(PlotCursor cursor, double x);
    void openMenu(QPoint at);
    void addCopyAndSave(QMenu& menu);
    void addView(QMenu& menu, QPoint at);
    void addCursors(QMenu& menu, QPoint at);
    void addCurves(QMenu& menu);
    void addScale(QMenu& menu, QCPAxis* axis, const QString& text);
    bool offersTime() const;
    QString pointText(const CurvePoint& point) const;

    Restyle m_restyle;
    CurveMeanings m_meanings;
    DataText m_dataText;
    PlotCursors m_cursors;
    HoverMark m_hover;
    ViewHistory m_history;
    CursorBar* m_bar;
    QPointer<QCPGraph> m_readGraph;
    bool m_current = true;

    Gesture m_gesture = Gesture::none;
    QPointF m_pressed;
    QVector<PannedAxis> m_panned;
    Qt::CursorShape m_pointer = Qt::ArrowCursor;
    bool m_panning = false;  // moved already, not only pressed
    PlotCursor m_grabbed = PlotCursor::a;
    PlotCursor m_lastCursor = PlotCursor::a;
    QPointer<QCPAxisRect> m_lastRect;  // clicked last: the one that keys zoom
};

}  // namespace drillwave
