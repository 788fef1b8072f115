// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/drilling/drilling_plot.h"

#include <algorithm>

#include "ui/pages/drilling/march_rects.h"
#include "ui/pages/drilling/scan_rects.h"
#include "ui/plot/legend_entries.h"

namespace drillwave {
namespace {

constexpr int mostColumnsOfScan = 5;  // of the legend
constexpr double noStretchOfLegend = 1e-3;

bool isSameAxis(const DrillingPicture& a, const DrillingPicture& b) {
    if (a.march.has_value() != b.march.has_value() || a.scan.has_value() != b.scan.has_value()) return false;
    if (a.units != b.units) return false;
    if (a.march && a.march->blows != b.march->blows) return false;
    return !a.scan || (a.scan->along == b.scan->along && a.scan->from == b.scan->from &&
                       a.scan->to == b.scan->to && a.scan->isLogarithmic == b.scan->isLogarithmic);
}

}  // namespace

DrillingPlot::DrillingPlot(QCustomPlot* plot) : StudyFrame(plot) {
    layOutAnew();
    useLegend(QMargins(7, 6, 7, 0));
    plot->plotLayout()->addElement(m_legend);
    if (!m_legend->layer()) m_legend->setLayer(QStringLiteral("legend"));
    for (QCPLayoutGrid** grid : {&m_front, &m_gaps}) {
        *grid = new QCPLayoutGrid;
        (*grid)->setColumnSpacing(6);
        plot->plotLayout()->addElement(*grid);
    }
    m_march = new MarchRects(*plot, this);
    m_scan = new ScanRects(*plot, *m_legend, this);
    m_legend->setWrap(mostColumnsOfScan);
    connect(plot, &QCustomPlot::beforeReplot, this,
            [this] { wrapLegend(*m_legend, m_plot->viewport().width(), mostColumnsOfScan); });
    connect(plot, &QCustomPlot::afterLayout, this, [this] { m_scan->placeMarks(); });
    view(m_scan->rates());
    for (const auto side : {QCPAxis::atBottom, QCPAxis::atLeft})
        for (const QCPAxisRect* rect : {m_march->gaps(), m_march->penetrations()})
            m_view->watch(rect->axis(side));
    addHere();
    addRunMarks();
    setStyle(PlotStyle::forPaper());
    showNothing({});
}

void DrillingPlot::present(const DrillingPicture& picture) {
    if (!picture.message.isEmpty()) return showNothing(picture.message);
    const bool otherAxes = !isSameAxis(m_picture, picture);
    m_picture = picture;
    arrange();
    m_march->present(picture.march.value_or(MarchPicture{}), picture.before, picture.units);
    m_view->adjust(
        [&] { m_scan->present(picture.scan.value_or(ScanPicture{}), picture.units, picture.isScanOld); });
    setStyle(m_style);
    setHere(picture.scan ? picture.installed : std::nullopt, {});
    m_summary = picture.march ? picture.march->summary : QString();
    if (picture.scan)
        m_summary += (m_summary.isEmpty() ? QString() : QStringLiteral(" ")) +
                     tr("Penetration rate, contact share and gaps over %1.").arg(picture.scan->along);
    finish(otherAxes);
}

void DrillingPlot::showRuns(const QVector<RunMark>& means, const QVector<RunMark>& along) {
    m_march->presentRuns(means);
    setRuns(along);
}

void DrillingPlot::clear() {
    m_march->presentRuns({});
    m_picture = {};
    arrange();
    m_march->present({}, {}, {});
    m_scan->present({}, {}, false);
}

void DrillingPlot::setDetailed(bool isDetailed) {
    m_isDetailed = isDetailed;
    arrange();
}

// Parts with nothing to show leave their room to the others.
void DrillingPlot::arrange() {
    const bool hasScan = m_picture.scan.has_value(), hasMarch = m_picture.march || !hasScan;
    struct Part {
        QCPLayout* parent;
        QCPLayoutElement* element;
        bool isShown;
        double stretch = 1;
    };
    QCPLayoutGrid* all = m_plot->plotLayout();
    const Part parts[] = {{m_front, m_scan->rates(), hasScan},
                          {m_front, m_march->penetrations(), hasMarch},
                          {m_gaps, m_march->gaps(), hasMarch && m_isDetailed},
                          {m_gaps, m_scan->gaps(), hasScan && m_isDetailed},
                          {all, m_legend, hasScan, noStretchOfLegend},
                          {all, m_front, true},
                          {all, m_gaps, m_isDetailed},
                          {all, m_march->details(), hasMarch && m_isDetailed}};
    if (std::ranges::all_of(
            parts, [](const Part& part) { return (part.element->layout() == part.parent) == part.isShown; }))
        return;
    for (const Part& part : parts)
        if (QCPLayout* layout = part.element->layout()) layout->take(part.element);
    for (QCPLayoutGrid* grid : {m_front, m_gaps, all}) grid->simplify();
    for (const Part& part : parts) {
        part.element->setVisible(part.isShown);
        if (!part.isShown) continue;
        if (part.parent != all) {
            auto* row = static_cast<QCPLayoutGrid*>(part.parent);
            row->addElement(0, row->columnCount(), part.element);
        } else {
            const int row = all->rowCount();
            all->addElement(row, 0, part.element);
            all->setRowStretchFactor(row, part.stretch);
        }
    }
}

void DrillingPlot::restyle() {
    m_march->setStyle(m_style);
    m_scan->setStyle(m_style);
}

void DrillingPlot::setRanges() {
    if (m_picture.march) m_march->fit();
    if (m_picture.scan) m_scan->fit();
}

bool DrillingPlot::isScan(const QCPAxisRect* rect) const {
    return m_picture.scan && (rect == m_scan->rates() || rect == m_scan->gaps());
}

KeyPlaces DrillingPlot::keyPlaces() const {
    KeyPlaces places;
    places.rect = m_scan->rates();
    places.on = KeyPlaces::On::points;
    places.start = [this]() -> std::optional<QPointF> {
        if (!m_picture.scan || m_picture.scan->scan.rate.isEmpty()) return std::nullopt;
        const QCPGraphData& first = m_picture.scan->scan.rate.first();
        return QPointF(first.key, first.value);
    };
    return places;
}

}  // namespace drillwave
