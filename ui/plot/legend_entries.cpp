// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/legend_entries.h"

#include <QSet>
#include <algorithm>
#include <numeric>
#include <vector>

namespace drillwave {
namespace {

QList<QCPLegend*> legendsOf(const QCustomPlot& plot) {
    QList<QCPLegend*> legends;
    for (QCPLayoutElement* element : plot.plotLayout()->elements(true))
        if (auto* legend = qobject_cast<QCPLegend*>(element)) legends.append(legend);
    return legends;
}

QList<QCPPlottableLegendItem*> entriesOf(const QCPLegend& legend) {
    QList<QCPPlottableLegendItem*> entries;
    for (int i = 0; i < legend.itemCount(); ++i)
        if (auto* entry = qobject_cast<QCPPlottableLegendItem*>(legend.item(i))) entries.append(entry);
    return entries;
}

bool hasPoints(const QCPAbstractPlottable& curve) {
    const auto* points = const_cast<QCPAbstractPlottable&>(curve).interface1D();
    return points && points->dataCount() > 0;
}

// Entries one after another in rows of so many.
double widthIn(int columns, const std::vector<double>& entries) {
    std::vector<double> widest(static_cast<std::size_t>(columns), 0);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        double& column = widest[i % static_cast<std::size_t>(columns)];
        column = std::max(column, entries[i]);
    }
    return std::accumulate(widest.begin(), widest.end(), 0.0);
}

}  // namespace

QList<QCPAbstractPlottable*> namedCurves(const QCustomPlot& plot) {
    QSet<const QCPAbstractPlottable*> inLegends;
    for (const QCPLegend* legend : legendsOf(plot))
        for (QCPPlottableLegendItem* entry : entriesOf(*legend)) inLegends.insert(entry->plottable());
    QList<QCPAbstractPlottable*> curves;
    for (int i = 0; i < plot.plottableCount(); ++i) {
        QCPAbstractPlottable* curve = const_cast<QCustomPlot&>(plot).plottable(i);
        if (inLegends.contains(curve)) curves.append(curve);
    }
    return curves;
}

QList<QCPAbstractPlottable*> visibleCurves(const QCustomPlot& plot) {
    QList<QCPAbstractPlottable*> curves = namedCurves(plot);
    curves.removeIf(
        [](const QCPAbstractPlottable* curve) { return !curve->realVisibility() || !hasPoints(*curve); });
    return curves;
}

QCPAbstractPlottable* legendEntryAt(const QCustomPlot& plot, QPointF point) {
    for (const QCPLegend* legend : legendsOf(plot)) {
        if (!legend->realVisibility()) continue;
        for (QCPPlottableLegendItem* entry : entriesOf(*legend))
            if (entry->selectTest(point, false) >= 0) return entry->plottable();
    }
    return nullptr;
}

void wrapLegend(QCPLegend& legend, double width, int mostColumns) {
    const QFontMetricsF metrics(legend.font());
    constexpr double edges = 6;
    const double besideName =
        legend.iconSize().width() + legend.iconTextPadding() + legend.columnSpacing() + edges;
    std::vector<double> widths;
    for (QCPPlottableLegendItem* entry : entriesOf(legend))
        widths.push_back(besideName + metrics.horizontalAdvance(entry->plottable()->name()));
    int columns = std::clamp(static_cast<int>(widths.size()), 1, mostColumns);
    while (columns > 1 && widthIn(columns, widths) > width) --columns;
    if (columns == legend.wrap()) return;
    legend.setWrap(columns);
    legend.setFillOrder(QCPLayoutGrid::foColumnsFirst, true);
}

void markHiddenCurves(QCustomPlot& plot) {
    for (const QCPLegend* legend : legendsOf(plot)) {
        QFont struckOut = legend->font();
        struckOut.setStrikeOut(true);
        QColor faded = legend->textColor();
        faded.setAlpha(150);
        for (QCPPlottableLegendItem* entry : entriesOf(*legend)) {
            const bool shown = entry->plottable()->visible();
            entry->setFont(shown ? legend->font() : struckOut);
            entry->setTextColor(shown ? legend->textColor() : faded);
        }
    }
}

WithoutHiddenEntries::WithoutHiddenEntries(QCustomPlot& plot) {
    for (const QCPLegend* legend : legendsOf(plot))
        for (QCPPlottableLegendItem* entry : entriesOf(*legend))
            if (entry->visible() && !entry->plottable()->visible()) m_entries.append(entry);
    for (QCPPlottableLegendItem* entry : m_entries) entry->setVisible(false);
}

WithoutHiddenEntries::~WithoutHiddenEntries() {
    for (QCPPlottableLegendItem* entry : m_entries) entry->setVisible(true);
}

}  // namespace drillwave
