// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/curve_reader.h"

#include <algorithm>
#include <limits>

#include "ui/plot/cursor_bar.h"
#include "ui/plot/curve_names.h"
#include "ui/plot/hover_mark.h"
#include "ui/plot/legend_entries.h"
#include "ui/plot/overlay.h"
#include "ui/text/settings.h"

namespace drillwave {
namespace {

constexpr double aimDistance = 40;  // [px]: a curve that near is the one that is meant

QList<QCPGraph*> visibleGraphs(const QCustomPlot& plot) {
    QList<QCPGraph*> graphs;
    for (QCPAbstractPlottable* curve : visibleCurves(plot))
        if (auto* graph = qobject_cast<QCPGraph*>(curve)) graphs.append(graph);
    return graphs;
}

}  // namespace

CurveReader::CurveReader(QCustomPlot& plot, const CurveMeanings& meanings)
    : m_plot(plot),
      m_meanings(meanings),
      m_cursors(plot),
      m_bar(new CursorBar(&plot)),
      m_tableShown(Settings().value(tableShownKey, true).toBool()) {
    m_bar->hide();
    connect(&plot, &QCustomPlot::afterReplot, this, &CurveReader::read);
    connect(m_bar, &CursorBar::curveChosen, this, &CurveReader::setGraph);
    connect(m_bar, &CursorBar::closed, this, [this] {
        clear();
        emit closed();
    });
}

void CurveReader::setTableShown(bool shown) {
    m_tableShown = shown;
    read();
}

void CurveReader::place(PlotCursor cursor, std::optional<double> x) {
    if (position(cursor) == x) return;
    m_cursors.place(cursor, x);
    if (cursor != PlotCursor::time) read();
    redrawOverlay(m_plot);
}

void CurveReader::clear() {
    place(PlotCursor::a, {});
    place(PlotCursor::b, {});
}

QCPGraph* CurveReader::graph() const {
    for (QCPGraph* wanted : {m_graph.data(), m_usual.data()})
        if (wanted && wanted->realVisibility()) return wanted;
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

void CurveReader::aim(QPointF pixel) {
    const QCPAxisRect* rect = m_plot.axisRectAt(pixel);
    QCPGraph* present = graph();
    const bool isHere = present && present->keyAxis()->axisRect() == rect;
    const bool isBusy = position(PlotCursor::a) || position(PlotCursor::b);
    if (!rect || (isHere && isBusy)) return;
    const auto near = nearestCurvePoint(m_plot, pixel, aimDistance);
    if (auto* pointed = near ? qobject_cast<QCPGraph*>(near->curve) : nullptr) return setGraph(pointed);
    if (isHere) return;
    for (QCPGraph* each : visibleGraphs(m_plot))
        if (each->keyAxis()->axisRect() == rect) return setGraph(each);
}

bool CurveReader::isBarShown() const {
    if (position(PlotCursor::a) || position(PlotCursor::b)) return true;
    // Only curves with a name are read.
    return m_tableShown && !m_meanings.isEmpty() && !m_cursors.rects().isEmpty() &&
           !namedCurves(m_plot).isEmpty();
}

void CurveReader::read() {
    if (isBarShown()) {
        const bool atCursors = position(PlotCursor::a) || position(PlotCursor::b);
        m_bar->setCurves(visibleGraphs(m_plot), graph());
        m_bar->present(atCursors ? cellsAtCursors() : cellsInView(),
                       atCursors ? CursorBar::Of::cursors : CursorBar::Of::view);
    }
    placeBar();
    emit changed();
}

CurveMeaning CurveReader::meaning() const {
    const QCPGraph* read = graph();
    CurveMeaning meaning = m_meanings.value(read);
    if (!read) return meaning;
    const QString x = xNameOf(*read, meaning);
    meaning.yName = yNameOf(*read, meaning);
    meaning.xName = x;
    return meaning;
}

// Works for a single cursor, too.
ReadingCells CurveReader::cellsAtCursors() const {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const std::optional<double> a = position(PlotCursor::a);
    const std::optional<double> b = position(PlotCursor::b);
    const QCPGraph* read = graph();
    CursorReading reading{none, none, none, none, none, none, none};
    if (read)
        reading = readCurve(*read->data(), meaning(), a.value_or(b.value_or(0)), b.value_or(a.value_or(0)));
    reading.a = a.value_or(none);
    reading.b = b.value_or(none);
    return cursorCells(reading, meaning());
}

ReadingCells CurveReader::cellsInView() const {
    const QCPGraph* read = graph();
    const QCPRange view = read ? read->keyAxis()->range() : QCPRange();
    return viewCells(viewStatistics(read ? *read->data() : QCPGraphDataContainer(), meaning(), view),
                     meaning());
}

void CurveReader::placeBar() {
    const bool shown = isBarShown();
    const int width = m_plot.width();
    const int height = m_plot.height();
    const int barHeight = shown ? std::min(m_bar->heightFor(width), height / 3) : 0;
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

void CurveReader::setCurrent(bool current) {
    m_bar->setCopyEnabled(current);
}

void CurveReader::copy() const {
    m_bar->copy();
}

}  // namespace drillwave
