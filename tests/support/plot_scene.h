// SPDX-License-Identifier: GPL-3.0-or-later
// Plot like those of the pages, for tests with mouse and keys.
#pragma once

#include <QAction>
#include <QCursor>
#include <QMenu>
#include <QTest>
#include <QWheelEvent>
#include <cmath>
#include <memory>

#include "ui/plot/curve_graph.h"
#include "ui/plot/plot_menu.h"
#include "ui/plot/plot_widget.h"

namespace drillwave::test {

/// Plot with two axis rects, linked x axes and a legend each. Above is a parabola, below a step and a falling
/// line; x is in ms, y in kN.
struct PlotScene {
    PlotWidget plot;
    QCPAxisRect* upper;
    QCPAxisRect* lower;
    QCPGraph* parabola;
    QCPGraph* step;
    QCPGraph* line;
    QCPLegend* legends[2];

    PlotScene() {
        plot.setAutoAddPlottableToLegend(false);
        plot.plotLayout()->clear();
        upper = addRect(0);
        lower = addRect(1);
        for (auto [from, to] : {std::pair(upper, lower), std::pair(lower, upper)})
            QObject::connect(x(from), qOverload<const QCPRange&>(&QCPAxis::rangeChanged), x(to),
                             qOverload<const QCPRange&>(&QCPAxis::setRange));
        parabola = addGraph(0, QStringLiteral("parabola"));
        step = addGraph(1, QStringLiteral("step"));
        line = addGraph(1, QStringLiteral("line, falling"));
        for (int i = 0; i <= 100; ++i) parabola->addData(i * 0.1, i * i * 0.01);
        step->setData({0, 4, 4, 10}, {1, 1, 3, 3}, true);
        line->setData({0, 10}, {0, -2}, true);
        x(lower)->setLabel(QStringLiteral("time t [ms]"));
        plot.followPalette([this](const PlotStyle& style) {
            plot.setBackground(style.background);
            for (QCPAxisRect* rect : {upper, lower}) style.applyTo(*rect);
            for (QCPLegend* legend : legends) style.applyTo(*legend);
            for (int i = 0; i < plot.graphCount(); ++i) plot.graph(i)->setPen(style.linePen(i));
        });
        QObject::connect(&plot, &PlotWidget::fitRequested, &plot, [this] { fit(); });
        fit();
        plot.resize(640, 520);
        plot.show();
        plot.setFocus();
    }

    QCPAxisRect* addRect(int index) {
        auto* rect = new QCPAxisRect(&plot);
        legends[index] = new QCPLegend;
        plot.plotLayout()->addElement(2 * index, 0, legends[index]);
        plot.plotLayout()->setRowStretchFactor(2 * index, 1e-3);
        plot.plotLayout()->addElement(2 * index + 1, 0, rect);
        legends[index]->setLayer(QStringLiteral("legend"));
        for (QCPAxis* axis : rect->axes()) axis->setLayer(QStringLiteral("axes"));
        return rect;
    }
    QCPGraph* addGraph(int rect, const QString& name) {
        QCPAxisRect* on = rect == 0 ? upper : lower;
        QCPGraph* graph = addCurve(x(on), y(on));
        graph->setName(name);
        graph->addToLegend(legends[rect]);
        CurveMeaning meaning;
        meaning.xUnit = QStringLiteral("ms");
        meaning.yUnit = QStringLiteral("kN");
        meaning.integralUnit = QStringLiteral("N s");
        plot.setMeaning(graph, meaning);
        return graph;
    }
    static QCPAxis* x(QCPAxisRect* rect) { return rect->axis(QCPAxis::atBottom); }
    static QCPAxis* y(QCPAxisRect* rect) { return rect->axis(QCPAxis::atLeft); }
    void fit() {
        x(upper)->setRange(0, 10);
        y(upper)->setRange(-10, 110);
        y(lower)->setRange(-3, 4);
    }
    // Returns the pixel of a point in the upper plot, or in the lower one.
    QPoint at(double time, double value, bool inLower = false) const {
        QCPAxisRect* rect = inLower ? lower : upper;
        return {qRound(x(rect)->coordToPixel(time)), qRound(y(rect)->coordToPixel(value))};
    }
    void wheel(QPoint point, int notches) {
        QWheelEvent event(point, plot.mapToGlobal(point), {}, QPoint(0, 120 * notches), Qt::NoButton,
                          Qt::ControlModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&plot, &event);
    }
    void drag(Qt::MouseButton button, Qt::KeyboardModifiers keys, QPoint from, QPoint to) {
        QTest::mousePress(&plot, button, keys, from);
        for (const QPoint point : {(2 * from + to) / 3, to}) {
            QMouseEvent move(QEvent::MouseMove, point, plot.mapToGlobal(point), Qt::NoButton, button, keys);
            QCoreApplication::sendEvent(&plot, &move);
        }
        QTest::mouseRelease(&plot, button, keys, to);
    }
    void hover(QPoint point) {
        QMouseEvent move(QEvent::MouseMove, point, plot.mapToGlobal(point), Qt::NoButton, Qt::NoButton,
                         Qt::NoModifier);
        QCoreApplication::sendEvent(&plot, &move);
    }
    void clickLegend(int legend, int entry) {
        QTest::mouseClick(&plot, Qt::LeftButton, {}, legends[legend]->item(entry)->rect().center());
    }
    QAction* action(const QString& text) {
        menu = std::make_unique<PlotMenu>(plot, upper->center());
        for (QAction* action : menu->findChildren<QAction*>())
            if (action->text().remove(QLatin1Char('&')).startsWith(text)) return action;
        return nullptr;
    }
    std::unique_ptr<QMenu> menu;
};

/// Returns true if a value differs from `wanted` by at most `tolerance`.
inline bool near(double value, double wanted, double tolerance) {
    return std::abs(value - wanted) <= tolerance;
}

}  // namespace drillwave::test
