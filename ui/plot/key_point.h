// SPDX-License-Identifier: GPL-3.0-or-later
// The point of a plot that keys move, and that Enter takes as a click does.
#pragma once

#include <qcustomplot.h>

#include <QObject>
#include <QPointer>
#include <functional>
#include <optional>

#include "ui/plot/cross_mark.h"

namespace drillwave {

class PlotWidget;

/// Places for the keyboard in a plot, in the coordinates of the bottom and left axes of one axis rect.
struct KeyPlaces {
    enum class On {
        curves,  ///< along the visible curves, and from one to the next
        points,  ///< from point to point of the visible curves
        area     ///< anywhere between the axes
    };
    QCPAxisRect* rect = nullptr;
    On on = On::curves;
    /// First place; the middle of the view if there is none.
    std::function<std::optional<QPointF>()> start = [] { return std::nullopt; };
    /// Places that are worth going to: extremes, kinks, presets.
    std::function<QVector<QPointF>()> marks = [] { return QVector<QPointF>(); };
    /// Further places that a click takes, each a thing by itself: cells of a coarse map.
    std::function<QVector<QPointF>()> targets = [] { return QVector<QPointF>(); };
    /// Describes a place, in addition to the numbers of the curve.
    std::function<QString(QPointF)> words = [](QPointF) { return QString(); };
};

/// It stays at its coordinates when the view changes, and on its curve when that does. Lives as a child of
/// the plot.
class KeyPoint : public QObject {
    Q_OBJECT

  public:
    explicit KeyPoint(PlotWidget& plot);

    /// Enables the keys here by the places that a page offers.
    void offer(KeyPlaces places);
    bool isOffered() const { return m_places.rect != nullptr; }

    /// Puts it where the places begin; no effect while it is there, or where there is nothing to go along.
    void enter();
    void leave();
    /// The place in coordinates; nothing before enter() and after leave().
    std::optional<QPointF> place() const { return m_place; }
    std::optional<QPointF> pixel() const;

    /// Moves it by pixels to the right and up. On points, by as many points to the right or up; on curves,
    /// any number upwards is one curve.
    void move(int right, int up);
    /// To the first or last place in view: of the curve, of the points, or of the line across the area.
    void goToEnd(bool last);
    /// To the next mark to the right, from the last to the first, or backwards; false without marks in view.
    bool goToMark(bool forward);
    /// Whether a mark or a target is within so many pixels.
    bool isOnMark(QPointF pixel, double reach) const;
    /// Does what a click there does.
    void take(Qt::KeyboardModifiers modifiers);

    /// Hides it for now, or shows it where it was.
    void setHidden(bool hidden);
    bool isHidden() const { return m_hidden; }
    void setStyle(const PlotStyle& style) { m_mark.setStyle(style); }
    /// Its label, empty while it is not shown.
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
    QPointer<QCPGraph> m_curve;  // it is on
    bool m_hidden = false;
    CrossMark m_mark;
};

}  // namespace drillwave
