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

/// Plot widget used on all pages of the window.
///
/// Mouse: the wheel with Ctrl zooms at the pointer; over an axis it zooms only that axis. Dragging pans;
/// dragging with Shift or with the right button zooms to a box. A double-click brings everything into view,
/// the back button returns to the previous view. A click on a legend entry hides or shows its curve. A click
/// on a curve chooses it for the readings below the plot. Cursors can be dragged.
///
/// Keys: arrows pan, + and − zoom, Home brings everything into view, Backspace or Alt+Left returns to the
/// previous view. A, B and T place cursors at the pointer, or in the middle if the pointer is elsewhere.
/// Ctrl+Left and Ctrl+Right move the cursor placed last by one pixel, with Shift by ten.
///
/// Keyboard point: if a page has offered places to keyPoint(), Enter shows a point there. Arrows move it by
/// one pixel (or from point to point, or from curve to curve), with Shift by ten. Home and End move it to the
/// ends, N and Shift+N to the next and the previous mark. Enter then acts like a click at the point,
/// Shift+Enter like a click with Shift; A and B place cursors there. Esc or a mouse click removes the point.
///
/// Focus: zooming with the wheel gives the plot the focus. Backspace, A, B and T act on the plot below the
/// pointer even if another widget has the focus, except for text fields.
///
/// Only curves with an entry in a legend can be read, hidden and copied. All axis rects with graphs are
/// assumed to share one x axis; the page links their ranges. All x and y are in the units of the axes.
class PlotWidget : public QCustomPlot {
    Q_OBJECT

  public:
    /// Function that applies a style to everything that a page draws in the plot.
    using Restyle = std::function<void(const PlotStyle&)>;
    /// Function that returns the data of the plot as a table, with `separator` between the cells.
    using DataText = std::function<QByteArray(char separator)>;

    explicit PlotWidget(QWidget* parent = nullptr);
    ~PlotWidget() override;

    /// Calls `restyle` with the style of the present palette, now and again whenever palette or font change.
    void followPalette(Restyle restyle);

    /// Sets the meaning of a curve: its units and, if they are known, the exact functions of which its points
    /// are samples. Set it again with every new result; it is forgotten when the curve is deleted.
    void setMeaning(const QCPAbstractPlottable* curve, const CurveMeaning& meaning);
    /// Returns the reader, which computes the values of a curve at the cursors and shows them below the plot.
    CurveReader& reader() { return m_reader; }
    CursorMover& mover() { return m_mover; }
    PlotView& view() { return m_view; }
    /// Returns the keyboard point, which the user moves by keys. A page calls its offer() to enable these
    /// keys.
    KeyPoint& keyPoint() { return *m_point; }
    /// Returns whether the plot has a time cursor. It has one if its page has connected the signal
    /// timeCursorDragged().
    bool offersTime() const;
    /// Shows a ring and a label at a point of a curve; removes them if `point` is empty.
    void markPoint(const std::optional<CurvePoint>& point);
    /// Returns the label of a point of a curve: the name of the curve, then x and y with their names and
    /// units.
    QString words(const CurvePoint& point) const;
    /// Returns the label shown at the mouse pointer for the nearest curve point; empty if there is none.
    QString hoverText() const { return m_hover.text(); }

    void setCurveVisible(QCPAbstractPlottable* curve, bool visible);
    /// Makes an axis linear or logarithmic. If plots are stacked, the horizontal axes of all of them change
    /// together.
    void setAxisScale(QCPAxis* axis, QCPAxis::ScaleType scale);

    /// Returns the present view as bytes of a file: black on white, with numbers in C locale, and with the
    /// placed cursors. `format` is one of plotFormats(); `dpi` is the resolution of PNG. See renderPlot().
    QByteArray drawing(const QString& format, Millimetres size, double dpi = standardDpi,
                       const QString& title = {});
    /// Returns the size [mm] that the plot has on paper if it is printed as large as on a screen with 96 dots
    /// per inch.
    Millimetres sizeOnPaper() const;
    /// Returns the data of the plot as CSV in English; see plotCsv().
    QByteArray csv() const { return dataText(','); }
    /// Returns whether the plot has data to copy or save: a visible curve with points, or data from the
    /// function set by setDataText().
    bool hasData() const;
    /// Sets the function that returns the data to copy and save, in the form of plotCsv(). Needed for plots
    /// without curves, such as maps.
    void setDataText(DataText text) { m_dataText = std::move(text); }
    /// Sets the function that names the curves and axes in the present language. It is called when csv()
    /// switches to English (EnglishTexts), and again afterwards.
    void setNaming(std::function<void()> name) { m_name = std::move(name); }

    /// Sets whether the plot shows results of the present input. An outdated plot cannot be copied or saved.
    void setCurrent(bool current);
    bool isCurrent() const { return m_current; }

    /// Opens the context menu for the point `at` of the plot [px]. If `at` is empty, the menu opens in the
    /// middle of the axis rect used last.
    void openMenu(std::optional<QPoint> at = {});

    QSize minimumSizeHint() const override { return {300, 240}; }

  public slots:
    /// Brings everything into view: emits fitRequested(), on which the page fits its axes, and fits
    /// logarithmic axes. The user can go back to the view before.
    void fit();
    void copyPicture();
    void copyData();

  signals:
    /// Asks the page to set axis ranges that bring everything into view.
    void fitRequested();
    /// Reports a click with the left button between the axes of `rect`. `coordinates` are those of its bottom
    /// and left axes. Pressing and releasing at different places is a drag, not a click.
    void clicked(QCPAxisRect* rect, QPointF coordinates, Qt::KeyboardModifiers modifiers);
    /// Reports a click on a curve or a mark, or Enter at the keyboard point. The page may then take the value
    /// there into the scenario. Clicks elsewhere, such as one that only gives the plot the focus, emit only
    /// clicked().
    void placeTaken(QCPAxisRect* rect, QPointF coordinates, Qt::KeyboardModifiers modifiers);
    /// Reports that the user has moved the time cursor to x (unit of the axis). A plot has a time cursor only
    /// if its page connects this signal.
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
    bool fitLabels();
    QList<QCPAxis*> labelledAxes() const;
    void restoreLabels();

    Restyle m_restyle;
    DataText m_dataText;
    std::function<void()> m_name;
    bool m_current = true;
    CurveMeanings m_meanings;
    struct FittedLabel {
        QString whole, fitting;
        QFont font;  // of the whole label
    };
    QHash<QCPAxis*, FittedLabel>
        m_fittedLabels;  // of axes whose labels are smaller, in two lines or shortened
    CurveReader m_reader;
    HoverMark m_hover;
    PlotView m_view;
    CursorMover m_mover;
    PlotMouse m_mouse;
    KeyPoint* m_point;
    PlotKeys* m_keys;
};

}  // namespace drillwave
