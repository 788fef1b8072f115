// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/blow/measured_curves.h"

#include <qcustomplot.h>

#include <cmath>

#include "ui/text/lightness.h"

namespace drillwave {
namespace {

// Apart from the colours of PlotStyle; contrast of at least 4.5 with the background.
constexpr QRgb onLight[] = {0xffa3004f, 0xff6b5300, 0xff005f73, 0xff4d4d4d};
constexpr QRgb onDark[] = {0xffff8fb3, 0xffe6c35c, 0xff7fd6e0, 0xffc8c8c8};

// Factors follow the scenario, and in SI are the same but for rounding.
bool isSame(double a, double b) {
    return std::abs(a - b) <= 1e-12 * std::abs(b);
}

GraphData shownData(const MeasuredSignal& signal, double timeFactor, double forceFactor) {
    QVector<QCPGraphData> points;
    points.reserve(static_cast<qsizetype>(signal.points.size()));
    for (const TablePoint& point : signal.points)
        appendFinite(points, (point.time + signal.timeShift) * timeFactor, point.force * forceFactor);
    return graphData(points);
}

BlowPlots::Kind kindOf(const MeasuredSignal& signal) {
    return signal.quantity == MeasuredQuantity::normalForce ? BlowPlots::Kind::waves
                                                            : BlowPlots::Kind::impactForce;
}

// Legends are one line.
QString legendName(const MeasuredSignal& signal) {
    constexpr int longest = 18;
    const QString name = QString::fromStdString(signal.name);
    return name.size() <= longest ? name : name.left(longest - 1) + QChar(0x2026);
}

}  // namespace

bool isComparable(const SolvedBlow& blow) {
    return hasUnits(blow.request.scenario) && blow.fault.isEmpty();
}

MeasuredCurves::MeasuredCurves(BlowPlots* plots)
    : QObject(plots), m_plots(plots), m_style(PlotStyle::forPaper()) {}

QPen MeasuredCurves::pen(const PlotStyle& style, int index) {
    static const QList<qreal> dashes[] = {{4, 1.5}, {10, 2, 2, 2}, {2, 1.2}, {7, 2}};
    constexpr int kinds = 4;
    const QRgb* colours = isDark(style.background) ? onDark : onLight;
    QPen pen(QColor::fromRgb(colours[index % kinds]), style.lineWidth);
    pen.setDashPattern(dashes[(index + index / kinds) % kinds]);
    pen.setCapStyle(Qt::FlatCap);
    pen.setJoinStyle(Qt::BevelJoin);
    return pen;
}

// Makes as many graphs as signals, each in the plot of its kind.
void MeasuredCurves::match(const std::vector<MeasuredSignal>& measured) {
    const auto sameKind = [&](std::size_t i) {
        return i < measured.size() && m_shown[i].signal.name == measured[i].name &&
               kindOf(m_shown[i].signal) == kindOf(measured[i]);
    };
    for (std::size_t i = m_shown.size(); i-- > 0;) {
        if (sameKind(i)) continue;
        m_plots->removeOverlay(m_graphs.takeAt(static_cast<qsizetype>(i)));
        m_shown.erase(m_shown.begin() + static_cast<std::ptrdiff_t>(i));
    }
    // The rest is in order; missing ones are inserted.
    for (std::size_t i = 0; i < measured.size(); ++i) {
        if (i < m_shown.size() && sameKind(i)) continue;
        const auto at = static_cast<std::ptrdiff_t>(i);
        m_graphs.insert(at, m_plots->addOverlay(kindOf(measured[i]), legendName(measured[i])));
        m_shown.insert(m_shown.begin() + at, Shown{measured[i]});
    }
    setStyle(m_style);
}

void MeasuredCurves::present(const std::vector<MeasuredSignal>& measured, const Scenario& scenario,
                             const ShownUnits& units) {
    match(measured);
    if (measured.empty()) return;
    const Scales scales = scalesOf(scenario);
    const double timeFactor = units.time.factor / scales.time;
    const double forceFactor = units.force.factor / scales.force;
    for (std::size_t i = 0; i < measured.size(); ++i) {
        Shown& shown = m_shown[i];
        const bool same = shown.signal == measured[i] && isSame(shown.timeFactor, timeFactor) &&
                          isSame(shown.forceFactor, forceFactor);
        if (same) continue;
        shown = {measured[i], timeFactor, forceFactor};
        QCPGraph* graph = m_graphs[static_cast<qsizetype>(i)];
        graph->setAdaptiveSampling(true);
        graph->setData(shownData(measured[i], timeFactor, forceFactor));
    }
}

void MeasuredCurves::setStyle(const PlotStyle& style) {
    m_style = style;
    for (int i = 0; i < m_graphs.size(); ++i) m_graphs[i]->setPen(pen(style, i));
}

}  // namespace drillwave
