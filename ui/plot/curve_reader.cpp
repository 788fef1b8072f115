// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/curve_reader.h"

#include <algorithm>
#include <limits>

#include "ui/plot/cursor_bar.h"
#include "ui/plot/legend_entries.h"

namespace drillwave {
namespace {

QList<QCPGraph*> visibleGraphs(const QCustomPlot& plot) {
    QList<QCPGraph*> graphs;
    for (QCPAbstractPlottable* curve : visibleCurves(plot))
        if (auto* graph = qobject_cast<QCPGraph*>(curve)) graphs.append(graph);
    return graphs;
}

}  // namespace

CurveReader::CurveReader(QCustomPlot& plot, const CurveMeanings& meanings)
    : m_plot(plot), m_meanings(meanings), m_cursors(plot), m_bar(new CursorBar(&plot)) {
    m_bar->hide();
    connect(&plot, &QCustomPlot::afterReplot, this, &CurveReader::read);
    connect(m_bar, &CursorBar::curveChosen, this, &CurveReader::setGraph);
    connect(m_bar, &CursorBar::closed, this, [this] {
        clear();
        emit closed();
    });
}

void CurveReader::place(PlotCursor cursor, std::optional<double> x) {
    if (position(cursor) == x) return;
    m_cursors.place(cursor, x);
    if (cursor != PlotCursor::time) read();
    m_plot.layer(QStringLiteral("overlay"))->replot();
}

void CurveReader::clear() {
    place(PlotCursor::a, {});
    place(PlotCursor::b, {});
}

QCPGraph* CurveReader::graph() const {
    if (m_graph && m_graph->realVisibility()) return m_graph;
    return visibleGraphs(m_plot).value(0);
}

void CurveReader::setGraph(QCPGraph* graph) {
    m_graph = graph;
    read();
}

std::optional<CursorReading> CurveReader::reading() const {
    const std::optional<double> a = position(PlotCursor::a);
    const std::optional<double> b = position(PlotCursor::b);
    const QCPGraph* read = graph();
    if (!a || !b || !read) return std::nullopt;
    return readCurve(*read->data(), m_meanings.value(read), *a, *b);
}

void CurveReader::read() {
    if (position(PlotCursor::a) || position(PlotCursor::b)) {
        m_bar->setCurves(visibleGraphs(m_plot), graph());
        m_bar->setText(words());
    }
    placeBar();
    emit changed();
}

// Also of one cursor alone.
QString CurveReader::words() const {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const std::optional<double> a = position(PlotCursor::a);
    const std::optional<double> b = position(PlotCursor::b);
    const QCPGraph* read = graph();
    const CurveMeaning meaning = m_meanings.value(read);
    CursorReading reading{none, none, none, none, none, none, none};
    if (read)
        reading = readCurve(*read->data(), meaning, a.value_or(b.value_or(0)), b.value_or(a.value_or(0)));
    reading.a = a.value_or(none);
    reading.b = b.value_or(none);
    return readingText(reading, meaning, m_plot.locale());
}

void CurveReader::placeBar() {
    const bool shown = position(PlotCursor::a) || position(PlotCursor::b);
    const int width = m_plot.width();
    const int height = m_plot.height();
    const int wanted = m_bar->hasHeightForWidth() ? m_bar->heightForWidth(width) : m_bar->sizeHint().height();
    // It grows for longer words but does not shrink for shorter ones: a drag shall not shake the curves.
    const int present = m_bar->isVisibleTo(&m_plot) && m_bar->width() == width ? m_bar->height() : 0;
    const int barHeight = shown ? std::min(std::max(wanted, present), height / 3) : 0;
    m_bar->setVisible(shown);
    m_bar->setGeometry(0, height - barHeight, width, barHeight);
    const QRect plotArea(0, 0, width, height - barHeight);
    if (m_plot.viewport() == plotArea) return;
    m_plot.setViewport(plotArea);
    m_plot.replot(QCustomPlot::rpQueuedReplot);
}

QString CurveReader::text() const {
    return m_bar->isVisibleTo(&m_plot) ? m_bar->text() : QString();
}

}  // namespace drillwave
