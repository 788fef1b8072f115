// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/gap/gap_plot.h"

#include <algorithm>

#include "core/text/units.h"
#include "ui/plot/curve_graph.h"
#include "ui/plot/number_ticks.h"
#include "ui/text/number_text.h"

namespace drillwave {
namespace {

constexpr double besideShare = 0.28;  // width of the distribution over that of the curve

bool sameAxes(const GapPicture& a, const GapPicture& b) {
    return a.output == b.output && a.gap.unit == b.gap.unit && a.value.unit == b.value.unit &&
           a.from == b.from && a.to == b.to;
}

QVector<QCPCurveData> curveData(const QVector<QPointF>& points) {
    QVector<QCPCurveData> data;
    for (const QPointF& point : points) data.append(QCPCurveData(double(data.size()), point.x(), point.y()));
    return data;
}

}  // namespace

GapPlot::GapPlot(QCustomPlot* plot) : StudyFrame(plot) {
    layOutAnew();
    addHeader(4);
    m_legend->setWrap(3);  // as many as fit beside each other with their names
    addRects();
    linkAxes();
    addLines();
    m_graph = addCurve(x(), y());
    m_graph->setAdaptiveSampling(false);
    m_graph->addToLegend(m_legend);
    m_shares = new QCPCurve(m_beside->axis(QCPAxis::atBottom), m_beside->axis(QCPAxis::atLeft));
    m_shares->setName(tr("share in a band"));
    m_shares->addToLegend(m_legend);
    m_below = new QCPCurve(m_beside->axis(QCPAxis::atTop), m_beside->axis(QCPAxis::atLeft));
    m_below->setName(tr("share below"));
    m_below->addToLegend(m_legend);
    m_marks = new CurveMarks(m_graph);
    addHere();
    addRunCurves();
    addRunMarks();
    connect(plot, &QCustomPlot::afterLayout, this, &GapPlot::placeBands);
    connect(plot, &QCustomPlot::beforeReplot, this, &GapPlot::breakCaption);
    setStyle(PlotStyle::forPaper());
}

void GapPlot::addRects() {
    view(newAxisRect(*m_plot, Sides::free));
    m_beside = newAxisRect(*m_plot, Sides::free);
    auto* row = new QCPLayoutGrid;
    m_plot->plotLayout()->addElement(1, 0, row);
    row->addElement(0, 0, m_rect);
    row->addElement(0, 1, m_beside);
    row->setColumnStretchFactor(1, besideShare);
    row->setColumnSpacing(0);
    auto* margins = new QCPMarginGroup(m_plot);
    for (QCPAxisRect* rect : {m_rect, m_beside}) {
        rect->setMarginGroup(QCP::msTop | QCP::msBottom, margins);
        rect->setMinimumMargins(QMargins(4, 4, 14, 4));
        rect->axis(QCPAxis::atRight)->setTicks(false);
        rect->axis(QCPAxis::atTop)->setTickLabels(true);
    }
    m_beside->axis(QCPAxis::atLeft)->setTickLabels(false);
    m_beside->axis(QCPAxis::atBottom)->ticker()->setTickCount(2);
    auto halves = QSharedPointer<NumberTicks<QCPAxisTickerFixed>>::create();
    halves->setTickStep(50);
    halves->setScaleStrategy(QCPAxisTickerFixed::ssMultiples);
    m_beside->axis(QCPAxis::atTop)->setTicker(halves);
    m_beside->axis(QCPAxis::atBottom)->setLabel(tr("in a band [%]"));
    m_beside->axis(QCPAxis::atTop)->setLabel(tr("below [%]"));
}

// Both rects have one axis of values, and the gap is on top in d0.
void GapPlot::linkAxes() {
    using Changed = void (QCPAxis::*)(const QCPRange&);
    constexpr auto changed = static_cast<Changed>(&QCPAxis::rangeChanged);
    QCPAxis* values = y();
    QCPAxis* same = m_beside->axis(QCPAxis::atLeft);
    connect(values, changed, same, [same](const QCPRange& range) { same->setRange(range); });
    connect(same, changed, values, [values](const QCPRange& range) { values->setRange(range); });
    QCPAxis* top = m_rect->axis(QCPAxis::atTop);
    connect(x(), changed, this, [this, top](const QCPRange& range) {
        top->setRange(range.lower / m_picture.gap.factor, range.upper / m_picture.gap.factor);
    });
}

void GapPlot::addLines() {
    for (const int side : {0, 1}) {
        QCPAxisRect* rect = side == 0 ? m_rect : m_beside;
        m_bands[side] = addItem<QCPItemRect>(rect, QStringLiteral("background"));
        for (QCPItemPosition* corner : m_bands[side]->positions()) setAcross(*corner);
        for (QCPItemStraightLine*& line : m_lines[side]) line = addLevel(rect, QStringLiteral("grid"));
    }
    for (QCPItemText*& name : m_lineNames) {
        name = addText(m_beside, QMargins(4, 1, 4, 1), Qt::AlignRight | Qt::AlignVCenter);
        name->setLayer(QStringLiteral("legend"));  // above the curves
        setAcross(*name->position);
    }
    m_bandName = addText(m_rect, QMargins(6, 3, 6, 3), Qt::AlignHCenter | Qt::AlignTop);
    m_bandName->setText(tr("super rebound, e > 1"));
    m_bandName->position->setType(QCPItemPosition::ptAxisRectRatio);
    m_bandName->position->setCoords(0.5, 0);
}

void GapPlot::present(const GapPicture& picture) {
    const bool otherAxes = !m_picture.curve || !sameAxes(m_picture, picture);
    m_picture = picture;
    setFramesVisible(true);
    m_graph->setData(picture.curve);
    m_graph->setName(gapOutputName(picture.output));
    y()->setLabel(picture.value.axisLabel(gapOutputName(picture.output)));
    x()->setLabel(picture.gap.axisLabel(tr("gap d")));
    QCPAxis* top = m_rect->axis(QCPAxis::atTop);
    top->setTickLabels(!picture.gap.dimensionless);
    top->setLabel(picture.gap.dimensionless ? QString() : tr("δ = gap / d₀"));
    m_shares->data()->set(curveData(picture.shares), true);
    m_below->data()->set(curveData(picture.below), true);
    showSpread();
    finish(otherAxes);
    m_marks->present(picture.marks, picture.gap, picture.value);
}

void GapPlot::clear() {
    m_picture = {};
    m_graph->data()->clear();
    m_shares->data()->clear();
    m_below->data()->clear();
    m_marks->clear();
    setFramesVisible(false);
    showSpread();
}

// Axes of nothing would only be behind the message.
void GapPlot::setFramesVisible(bool visible) {
    for (const QCPAxisRect* rect : {m_rect, m_beside})
        for (QCPAxis* axis : rect->axes()) axis->setVisible(visible);
    m_legend->setVisible(visible);
}

// 5 %, mean and 95 %, through both rects.
void GapPlot::showSpread() {
    const bool isShown = m_picture.curve && !m_picture.marks.empty();
    const GapSpread& spread = m_picture.spread;
    const double values[] = {spread.quantiles.front().value, spread.mean.value,
                             spread.quantiles.back().value};
    const QString names[] = {tr("5 %"), tr("mean"), tr("95 %")};
    for (int i = 0; i < 3; ++i) {
        const double at = values[i] * m_picture.value.factor;
        for (const auto& side : m_lines) setLevel(*side[i], isShown ? std::optional(at) : std::nullopt);
        m_lineNames[i]->setVisible(isShown);
        m_lineNames[i]->setText(names[i]);
        m_lineNames[i]->position->setCoords(1, at);
    }
    if (!m_picture.curve) return;
    m_summary = m_picture.shares.isEmpty() ? QString() : summary();
    m_caption->setText(m_summary);
}

// A narrow plot has a line for each part of it.
void GapPlot::breakCaption() {
    const double width = QFontMetricsF(m_caption->font()).horizontalAdvance(m_summary);
    QString text = m_summary;
    if (width > m_plot->viewport().width() - 20)
        text.replace(QStringLiteral(" · "), QString(QLatin1Char('\n')));
    if (m_picture.curve) m_caption->setText(text);
}

QString GapPlot::summary() const {
    const QLocale locale = m_plot->locale();
    const auto shown = [&](const Estimate& estimate) {
        const QString text = numberText(estimate.value * m_picture.value.factor, 4, locale);
        return m_picture.value.unit.isEmpty() ? text : text + QChar(QChar::Nbsp) + m_picture.value.unit;
    };
    const GapSpread& spread = m_picture.spread;
    QString text =
        (m_picture.isScattered ? tr("scattered gap: mean %1, 5–95 % %2…%3")
                               : tr("all gaps: mean %1, 5–95 % %2…%3"))
            .arg(shown(spread.mean), shown(spread.quantiles.front()), shown(spread.quantiles.back()));
    if (m_picture.shareAboveOne)
        text += tr(" · e > 1 at %1 of gaps").arg(percentText(*m_picture.shareAboveOne, 4, locale));
    if (m_picture.thrust)
        text += tr(" · thrust for 95 % of gaps %1")
                    .arg(numberText(*m_picture.thrust, 4, locale) + QChar(QChar::Nbsp) +
                         m_picture.thrustUnit.unit);
    return text;
}

// Above 1, as far as that is in view: files do not clip.
void GapPlot::placeBands() {
    const QCPRange view = y()->range();
    const bool isShown = m_picture.curve && m_picture.output == GapOutput::cor && view.upper > 1;
    for (QCPItemRect* band : m_bands) {
        band->setVisible(isShown);
        band->topLeft->setCoords(0, view.upper);
        band->bottomRight->setCoords(1, std::max(1.0, view.lower));
    }
    m_bandName->setVisible(isShown);
}

void GapPlot::restyle() {
    m_beside->axis(QCPAxis::atTop)->grid()->setVisible(false);
    m_graph->setPen(m_style.linePen(0));
    m_shares->setPen(QPen(m_style.lines[0], 1));
    m_shares->setBrush(m_style.areaBrush(0));
    m_below->setPen(m_style.linePen(1));
    for (QCPItemRect* band : m_bands) {
        band->setPen(Qt::NoPen);
        band->setBrush(m_style.areaBrush(2));
    }
    for (const auto& side : m_lines)
        for (int i = 0; i < 3; ++i)
            side[i]->setPen(QPen(m_style.zeroLine, 1, i == 1 ? Qt::DashDotLine : Qt::DashLine));
    for (QCPItemText* name : m_lineNames) name->setBrush(m_style.behindWords());
    m_marks->setStyle(m_style);
    if (!m_picture.curve) return;
    showSpread();  // files have another locale
    m_marks->present(m_picture.marks, m_picture.gap, m_picture.value);
}

KeyPlaces GapPlot::keyPlaces() const {
    KeyPlaces places;
    places.rect = m_rect;
    places.start = [this] { return here().place(); };
    places.marks = [this] {
        QVector<QPointF> marks;
        for (const CurveMark& mark : m_picture.marks) marks.append(mark.at);
        return m_graph->visible() ? marks : QVector<QPointF>();
    };
    return places;
}

void GapPlot::setRanges() {
    const double room = 0.02 * (m_picture.to - m_picture.from);
    x()->setRange(m_picture.from - room, m_picture.to + room);
    bool found = false;
    QCPRange values = m_graph->getValueRange(found);
    if (!found) values = {0, 1};
    for (QCPGraph* run : runCurves()) {
        bool isThere = false;
        const QCPRange range = run->getValueRange(isThere);
        if (isThere) values.expand(range);
    }
    const double size = std::max(values.size(), 0.02 * std::abs(values.upper));
    // Where super rebound begins, if that leaves the curves most of the height.
    constexpr double share = 0.25;
    const bool isNear = values.upper > 1 - share * size && values.lower < 1 + share * size;
    if (m_picture.output == GapOutput::cor && isNear) values.expand(1);
    y()->setRange(values.lower - 0.1 * size, values.upper + 0.1 * size);
    const auto shares = m_shares->getKeyRange(found);
    m_beside->axis(QCPAxis::atBottom)->setRange(0, found && shares.upper > 0 ? 1.05 * shares.upper : 100);
    m_beside->axis(QCPAxis::atTop)->setRange(0, 105);
}

}  // namespace drillwave
