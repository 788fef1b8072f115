// SPDX-License-Identifier: GPL-3.0-or-later
// A point on a plot that the arrow keys move; pressing Enter acts like a click there.
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <QPointer>
#include <functional>
#include <optional>

#include "ui/plot/cross_mark.h"

namespace drillwave {

class PlotWidget;

/// Places that the keyboard point can reach in a plot, in the coordinates of the bottom and left axes of
/// `rect`.
struct KeyPlaces {
    /// Way in which the arrow keys move the keyboard point.
    enum class On {
        curves,  ///< along a visible curve; up and down change to another curve
        points,  ///< from point to point of the visible curves
        area     ///< anywhere between the axes
    };
    /// Axis rect whose places the keyboard point can reach; nullptr if there are none in this plot.
    QCPAxisRect* rect = nullptr;
    On on = On::curves;
    /// Function that returns the place where the keyboard point first appears. If it returns nothing, the
    /// point appears in the middle of the view.
    std::function<std::optional<QPointF>()> start = [] { return std::nullopt; };
    /// Function that returns the marks of the plot, such as extremes, kinks and presets. The key N moves the
    /// keyboard point from mark to mark.
    std::function<QVector<QPointF>()> marks = [] { return QVector<QPointF>(); };
    /// Function that returns further places on which a click has an effect, such as the grid points of a
    /// coarse map.
    std::function<QVector<QPointF>()> targets = [] { return QVector<QPointF>(); };
    /// Function that returns a description of a place, such as the value of a map. It is shown at the
    /// keyboard point, above the readings of the curve. It may be empty.
    std::function<QString(QPointF)> words = [](QPointF) { return QString(); };
};

/// Keyboard point: a point on a plot that the user moves by keys, as an alternative to the mouse. It keeps
/// its coordinates when the view changes, and stays on its curve when the curve changes. The plot owns it.
class KeyPoint : public QObject {
    Q_OBJECT

  public:
    explicit KeyPoint(PlotWidget& plot);

    /// Sets the places that the keyboard point can reach. This enables its keys and hides the point.
    void offer(KeyPlaces places);
    /// Returns whether the plot has places that the keyboard point can reach.
    bool isOffered() const { return m_places.rect != nullptr; }

    /// Shows the keyboard point at the start place set by offer(), or in the middle of the view if there is
    /// none. Does nothing if the point is already shown, or if no place can be reached.
    void enter();
    /// Hides the keyboard point and forgets its place.
    void leave();
    /// Returns the place of the keyboard point in coordinates of the axes; nothing while there is no point,
    /// that is before enter() and after leave().
    std::optional<QPointF> place() const { return m_place; }
    /// Returns the place of the keyboard point in pixels of the plot; nothing while there is no point, that
    /// is before enter() and after leave().
    std::optional<QPointF> pixel() const;

    /// Moves the keyboard point by pixels to the right and upwards (negative: left, down). With On::points,
    /// `right` and `up` count points instead of pixels. With On::curves, any vertical step changes to the
    /// next curve.
    void move(int right, int up);
    /// Moves the keyboard point to the last place in view on the right if `last`, else to the first one on
    /// the left. It moves along its curve, from point to point, or along a horizontal line, depending on
    /// KeyPlaces::On.
    void goToEnd(bool last);
    /// Moves the keyboard point to the next mark to the right, or to the left if not `forward`. After the
    /// last mark it continues at the other end. Returns false if no mark is in view.
    bool goToMark(bool forward);
    /// Returns whether a mark or a click target passed to offer(), such as a point of a map, is within
    /// `reach` [px] of a pixel.
    bool isOnMark(QPointF pixel, double reach) const;
    /// Acts like a mouse click at the place of the keyboard point, with these modifier keys. Emits clicked()
    /// and placeTaken() of the plot.
    void take(Qt::KeyboardModifiers modifiers);

    /// Hides the keyboard point, but keeps its place, or shows it there again. Used while the plot has no
    /// focus, or is drawn to a file.
    void setHidden(bool hidden);
    bool isHidden() const { return m_hidden; }
    void setStyle(const PlotStyle& style) { m_mark.setStyle(style); }
    /// Returns the label beside the keyboard point; empty while the point is not shown.
    QString text() const { return m_mark.text(); }

  private:
    QPointF toPixel(QPointF place) const;
    QPointF toPlace(QPointF pixel) const;
    bool isInView(QPointF place) const;
    QList<QCPGraph*> curves() const;
    QVector<QPointF> points(Qt::Orientation along) const;
    std::pair<double, double> ends(const QCPGraph& curve) const;
    bool putOn(QCPGraph* curve, double x);
    bool putOnNearest(QPointF place);
    void putAtPoint(const QVector<QPointF>& sorted, qsizetype steps);
    void changeCurve(bool up);
    void put(QPointF place);
    void follow();
    void show();
    QString words() const;
    QCPGraph* curveHere() const;

    PlotWidget& m_plot;
    KeyPlaces m_places;
    std::optional<QPointF> m_place;
    QPointer<QCPGraph> m_curve;  // the curve that the point is on
    bool m_hidden = false;
    CrossMark m_mark;
};

}  // namespace drillwave
