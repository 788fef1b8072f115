// SPDX-License-Identifier: GPL-3.0-or-later
// A plot on screen, with the same zooming, panning, reading and copying on every page. It follows palette,
// font and screen.
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

/// Plot widget of all pages.
///
/// Mouse: the wheel with Ctrl zooms at the pointer; over an axis it zooms only that axis. Dragging pans;
/// dragging with Shift or with the right button zooms to a box. A double-click fits, the back button goes
/// back. A click on a legend entry hides or shows its curve; a click on a curve chooses it for reading.
/// Cursors can be dragged.
///
/// Keys: arrows pan, + and − zoom, Home fits, Backspace or Alt+Left goes back. A, B and T place cursors at
/// the pointer, or in the middle if the pointer is elsewhere. Ctrl+Left and Ctrl+Right move the cursor placed
/// last by one pixel, with Shift by ten.
///
/// Point for keys: if a page has offered places to keyPoint(), Enter shows a point there. Arrows move it by
/// one pixel (or from point to point, or from curve to curve), with Shift by ten. Home and End move it to the
/// ends, N and Shift+N to the next and the previous mark. Enter then acts like a click at the point,
/// Shift+Enter like a click with Shift; A and B place cursors there. Esc or a mouse click removes the point.
///
/// Focus: zooming with the wheel gives the plot the focus. Backspace, A, B and T act on the plot below the
/// pointer even if another widget has the focus, except for text fields.
///
/// Only curves with an entry in a legend are read, hidden and copied. All axis rects with graphs are assumed
/// to share one x axis; the page links their ranges. All x and y are in the units of the axes.
class PlotWidget : public QCustomPlot {
    Q_OBJECT

  public:
    /// Function that applies a style to everything that a page draws in the plot.
    using Restyle = std::function<void(const PlotStyle&)>;
    /// Function that returns the data of the plot as a table, with `separator` between the cells.
    using DataText = std::function<QByteArray(char separator)>;

    explicit PlotWidget(QWidget* parent = nullptr);
    ~PlotWidget() override;

    /// Applies the style of the present palette by `restyle` now, and again whenever palette or font change.
    void followPalette(Restyle restyle);

    /// Sets the meaning of a curve: its units, and the exact functions that its points sample, if there are
    /// any. Set it again with every new result; it is forgotten when the curve is deleted.
    void setMeaning(const QCPAbstractPlottable* curve, const CurveMeaning& meaning);
    /// Returns the reader of the curves at the cursors.
    CurveReader& reader() { return m_reader; }
    CursorMover& mover() { return m_mover; }
    PlotView& view() { return m_view; }
    /// Returns the point that the keys move. A page calls its offer() to enable the keys.
    KeyPoint& keyPoint() { return *m_point; }
    /// Returns whether the page uses the time cursor, that is, whether it has connected timeCursorDragged().
    bool offersTime() const;
    /// Shows a ring and a label at a point of a curve; removes them if `point` is empty.
    void markPoint(const std::optional<CurvePoint>& point);
    /// Returns a text with the curve's name and the point's x and y, with names and units.
    QString words(const CurvePoint& point) const;
    /// Returns the label of the mark at the mouse pointer; empty if there is none.
    QString hoverText() const { return m_hover.text(); }

    void setCurveVisible(QCPAbstractPlottable* curve, bool visible);
    /// Sets an axis linear or logarithmic. A horizontal axis takes those of all stacked plots along.
    void setAxisScale(QCPAxis* axis, QCPAxis::ScaleType scale);

    /// Returns the present view as bytes of a file: black on white, with numbers in C locale, and with the
    /// placed cursors. `format` is one of plotFormats(); `dpi` is the resolution of PNG. See renderPlot().
    QByteArray drawing(const QString& format, Millimetres size, double dpi = standardDpi,
                       const QString& title = {});
    /// Returns the size of the plot on screen [mm], at 96 dots per inch.
    Millimetres sizeOnPaper() const;
    /// Returns the data of the plot as CSV in English; see plotCsv().
    QByteArray csv() const { return dataText(','); }
    /// Returns whether the plot has data to copy: a visible curve with points, or a function set by
    /// setDataText().
    bool hasData() const;
    /// Sets the function that returns the data of a plot without curves, in the form of plotCsv().
    void setDataText(DataText text) { m_dataText = std::move(text); }
    /// Sets the function that names curves and axes in the present language. It is called again when csv()
    /// switches to English (EnglishTexts) and back.
    void setNaming(std::function<void()> name) { m_name = std::move(name); }

    /// Sets whether the plot belongs to the present input. An outdated plot cannot be copied or saved.
    void setCurrent(bool current);
    bool isCurrent() const { return m_current; }

    /// Opens the context menu for a point of the plot [px], or for the middle of the axis rect used last if
    /// `at` is empty.
    void openMenu(std::optional<QPoint> at = {});

    QSize minimumSizeHint() const override { return {300, 240}; }

  public slots:
    /// Saves the present view for going back, emits fitRequested() and fits logarithmic axes.
    void fit();
    void copyPicture();
    void copyData();

  signals:
    /// Asks the page to bring everything into view.
    void fitRequested();
    /// Reports a click with the left button, pressed and released at one place of `rect`. `coordinates` are
    /// those of its bottom and left axes.
    void clicked(QCPAxisRect* rect, QPointF coordinates, Qt::KeyboardModifiers modifiers);
    /// Reports a click on a curve or a mark, or Enter at the point for keys. The page may then change the
    /// scenario. Clicks elsewhere, such as one that only gives the plot the focus, emit only clicked().
    void placeTaken(QCPAxisRect* rect, QPointF coordinates, Qt::KeyboardModifiers modifiers);
    /// Reports that the user has moved the time cursor to x (unit of the axis). A page that connects this
    /// signal offers the time cursor.
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
    void followSizes();
    void fitLabels();
    void restoreLabels();

    Restyle m_restyle;
    DataText m_dataText;
    std::function<void()> m_name;
    bool m_current = true;
    CurveMeanings m_meanings;
    QHash<QCPAxis*, QString> m_wholeLabels;  // full labels of axes with abbreviated ones
    CurveReader m_reader;
    HoverMark m_hover;
    PlotView m_view;
    CursorMover m_mover;
    PlotMouse m_mouse;
    KeyPoint* m_point;
    PlotKeys* m_keys;
};

}  // namespace drillwave
