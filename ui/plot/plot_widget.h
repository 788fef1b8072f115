// SPDX-License-Identifier: GPL-3.0-or-later
// A plot on screen: zooms, pans, reads and copies alike on every page, and follows palette, font and screen.
#pragma once

#include <qcustomplot.h>

#include <QByteArray>
#include <functional>
#include <optional>

#include "ui/plot/cursor_mover.h"
#include "ui/plot/curve_meaning.h"
#include "ui/plot/curve_reader.h"
#include "ui/plot/hover_mark.h"
#include "ui/plot/key_point.h"
#include "ui/plot/plot_csv.h"
#include "ui/plot/plot_mouse.h"
#include "ui/plot/plot_rendering.h"
#include "ui/plot/plot_style.h"
#include "ui/plot/plot_view.h"

namespace drillwave {

class PlotKeys;

/// Mouse: the wheel zooms at the pointer (over an axis only that axis), dragging pans, dragging with Shift or
/// with the right button zooms to a box, a double-click fits, the back button goes back, a click on a legend
/// entry hides or shows its curve, a click on a curve has it read at the cursors; cursors can be dragged.
/// Keys: arrows pan, + and − zoom, Home fits, Backspace or Alt+Left goes back, A, B and T place cursors at
/// the pointer (in the middle when it is elsewhere), Ctrl+Left and Ctrl+Right move the cursor placed last by
/// a pixel, with Shift by ten. Where a page has offered places to keyPoint(), Enter puts a point there, which
/// arrows move by a pixel (from point to point, from curve to curve), with Shift by ten, Home and End to the
/// ends, N and Shift+N to the next and the last mark; Enter then is a click there, Shift+Enter one with
/// Shift, A and B place cursors there, and Esc takes it away, as a click of the mouse does. The wheel takes
/// the focus; Backspace, A, B and T go to the plot below the pointer wherever the focus is, but in fields for
/// text.
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

    /// Sets the meaning of a curve: units for all readings, and the exact functions behind its points if
    /// there are any. Set it again with every result; forgotten with the curve.
    void setMeaning(const QCPAbstractPlottable* curve, const CurveMeaning& meaning);
    /// The cursors, and what they read.
    CurveReader& reader() { return m_reader; }
    CursorMover& mover() { return m_mover; }
    PlotView& view() { return m_view; }
    /// The point that keys move; a page offers its places.
    KeyPoint& keyPoint() { return *m_point; }
    /// Whether the page follows the time cursor: it has connected timeCursorDragged().
    bool offersTime() const;
    /// Marks a point of a curve and reads it in words, or nothing.
    void markPoint(const std::optional<CurvePoint>& point);
    /// A point of a curve in words.
    QString words(const CurvePoint& point) const;
    /// The mark at the pointer, in words; empty when there is none.
    QString hoverText() const { return m_hover.text(); }

    void setCurveVisible(QCPAbstractPlottable* curve, bool visible);
    /// Linear or logarithmic; a horizontal axis together with those of all stacked plots.
    void setAxisScale(QCPAxis* axis, QCPAxis::ScaleType scale);

    /// The present view drawn for paper, black on white, numbers as in files, with cursors where they are
    /// placed; `format` is one of plotFormats(), `dpi` counts for PNG. See renderPlot().
    QByteArray drawing(const QString& format, Millimetres size, double dpi = standardDpi,
                       const QString& title = {});
    /// The size of the plot on screen at 96 dots per inch.
    Millimetres sizeOnPaper() const;
    /// The data of the plot as CSV; see plotCsv().
    QByteArray csv() const { return dataText(','); }
    bool hasData() const;
    /// Sets the text of a plot without curves, with a separator between cells, in the form of plotCsv().
    void setDataText(DataText text) { m_dataText = std::move(text); }
    /// Sets the function that names curves and axes in the present language (EnglishTexts): csv() is in
    /// English.
    void setNaming(std::function<void()> name) { m_name = std::move(name); }

    /// Whether what is shown answers the present input; nothing else is copied or saved.
    void setCurrent(bool current);
    bool isCurrent() const { return m_current; }

    /// The context menu for a point of the plot; without one for the middle of the axes used last.
    void openMenu(std::optional<QPoint> at = {});

    QSize minimumSizeHint() const override { return {300, 240}; }

  public slots:
    /// Keeps the view to go back to and asks the page to fit.
    void fit();
    void copyPicture();
    void copyData();

  signals:
    /// The page is to bring everything into view.
    void fitRequested();
    /// A click with the left button, pressed and released at one place of an axis rect: its coordinates on
    /// the bottom and left axes there.
    void clicked(QCPAxisRect* rect, QPointF coordinates, Qt::KeyboardModifiers modifiers);
    /// A click on a curve or a mark, or Enter at the point of the keys: the page may then change the
    /// scenario. Clicks beside them, such as one that only gives the plot the focus, change nothing.
    void placeTaken(QCPAxisRect* rect, QPointF coordinates, Qt::KeyboardModifiers modifiers);
    /// The user moves the time cursor; it is there already. A page that connects this offers the cursor.
    void timeCursorDragged(double x);
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
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

  private:
    QByteArray dataText(char separator) const;
    void restyle();
    void applyStyle(const PlotStyle& style);
    void followScreen();
    void prepareReplot();
    void followHeights();

    Restyle m_restyle;
    DataText m_dataText;
    std::function<void()> m_name;
    bool m_current = true;
    CurveMeanings m_meanings;
    CurveReader m_reader;
    HoverMark m_hover;
    PlotView m_view;
    CursorMover m_mover;
    PlotMouse m_mouse;
    KeyPoint* m_point;
    PlotKeys* m_keys;
};

}  // namespace drillwave
