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

/// Places that the keyboard can reach in a plot, in the coordinates of the bottom and left axes of `rect`.
struct KeyPlaces {
    /// Movement of the point by the arrow keys.
    enum class On {
        curves,  ///< along a visible curve; up and down change to another curve
        points,  ///< from point to point of the visible curves
        area     ///< anywhere between the axes
    };
    /// Axis rect of the places; nullptr if the keys have no places in this plot.
    QCPAxisRect* rect = nullptr;
    On on = On::curves;
    /// Function that returns the place where the point appears. If it returns nothing, the point appears in
    /// the middle of the view.
    std::function<std::optional<QPointF>()> start = [] { return std::nullopt; };
    /// Function that returns notable places that the key N jumps to, such as extremes, kinks and presets.
    std::function<QVector<QPointF>()> marks = [] { return QVector<QPointF>(); };
    /// Function that returns further places that a click selects, such as the cells of a coarse map.
    std::function<QVector<QPointF>()> targets = [] { return QVector<QPointF>(); };
    /// Function that returns a description of a place, which is shown above the numbers of the curve; may be
    /// empty.
    std::function<QString(QPointF)> words = [](QPointF) { return QString(); };
};

/// Point on a plot that the keys move. It keeps its coordinates when the view changes, and stays on its curve
/// when the curve changes. The plot owns it.
class KeyPoint : public QObject {
    Q_OBJECT

  public:
    explicit KeyPoint(PlotWidget& plot);

    /// Sets the places that the keys can reach, which enables the keys, and hides the point.
    void offer(KeyPlaces places);
    /// Returns whether the plot has places for the keys.
    bool isOffered() const { return m_places.rect != nullptr; }

    /// Shows the point at the start of the offered places. Does nothing if the point is already shown or no
    /// place is available.
    void enter();
    /// Hides the point and forgets its place.
    void leave();
    /// Returns the place of the point in coordinates of the axes; nothing before enter() and after leave().
    std::optional<QPointF> place() const { return m_place; }
    /// Returns the place of the point in pixels of the plot; nothing before enter() and after leave().
    std::optional<QPointF> pixel() const;

    /// Moves the point by pixels to the right and upwards (negative: left, down). With On::points the numbers
    /// count points. With On::curves any vertical step changes to the next curve.
    void move(int right, int up);
    /// Moves the point to the last place in view if `last`, else to the first one. Depending on
    /// KeyPlaces::On, the places are those of its curve, of all points, or of the horizontal line through the
    /// point.
    void goToEnd(bool last);
    /// Moves the point to the next mark to the right, or to the left if not `forward`, continuing at the
    /// other end. Returns false if no mark is in view.
    bool goToMark(bool forward);
    /// Returns whether a mark or a target of the offered places is within `reach` [px] of a pixel.
    bool isOnMark(QPointF pixel, double reach) const;
    /// Acts like a click at the place of the point: emits clicked() and placeTaken() of the plot.
    void take(Qt::KeyboardModifiers modifiers);

    /// Hides the point without forgetting its place, or shows it there again.
    void setHidden(bool hidden);
    bool isHidden() const { return m_hidden; }
    void setStyle(const PlotStyle& style) { m_mark.setStyle(style); }
    /// Returns the label of the point; empty while the point is not shown.
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
