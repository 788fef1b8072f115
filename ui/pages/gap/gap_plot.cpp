// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/gap/gap_plot.h"

#include <algorithm>

#include "core/text/units.h"
#include "ui/plot/curve_graph.h"
#include "ui/text/number_text.h"

namespace drillwave {
namespace {

constexpr double besideShare = 0.28;  // width of the distribution over that of the curve

QString percentText(double share, const QLocale& locale) {
    return numberText(100 * share, 4, locale) + QChar(QChar::Nbsp) + QLatin1Char('%');
}

bool sameAxes(const GapPicture& a, const GapPicture& b) {
    return a.output == b.output && a.gap.unit == b.gap.unit && a.value.unit == b.value.unit &&
           a.from == b.from && a.to == b.to;
}

QCPAxisRect* newRect(QCustomPlot* plot) {
    auto* rect = new QCPAxisRect(plot);
    rect->setupFullAxesBox(false);
    // Drawn in the order of these lines: axes() comes in another order in every run of the program.
    for (const auto side : {QCPAxis::atLeft, QCPAxis::atRight, QCPAxis::atTop, QCPAxis::atBottom}) {
        rect->axis(side)->setLayer(QStringLiteral("axes"));
        rect->axis(side)->grid()->setLayer(QStringLiteral("grid"));
    }
    return rect;
}

QVector<QCPCurveData> curveData(const QVector<QPointF>& points) {
    QVector<QCPCurveData> data;
    for (const QPointF& point : points) data.append(QCPCurveData(double(data.size()), point.x(), point.y()));
    return data;
}

}  // namespace

GapPlot::GapPlot(QCustomPlot* plot) : QObject(plot), m_plot(plot), m_view(new FittedView(this)) {
    plot->setAutoAddPlottableToLegend(false);
    plot->plotLayout()->clear();
    addLegend();
    addRects();
    linkAxes();
    addLines();
    m_graph = addCurve(m_rect->axis(QCPAxis::atBottom), m_rect->axis(QCPAxis::atLeft));
    m_graph->setAdaptiveSampling(false);
    m_shares = new QCPCurve(m_beside->axis(QCPAxis::atBottom), m_beside->axis(QCPAxis::atLeft));
    m_shares->setName(tr("share in a band"));
    m_below = new QCPCurve(m_beside->axis(QCPAxis::atTop), m_beside->axis(QCPAxis::atLeft));
    m_below->setName(tr("share below"));
    for (QCPAbstractPlottable* curve :
         {static_cast<QCPAbstractPlottable*>(m_graph), static_cast<QCPAbstractPlottable*>(m_shares),
          static_cast<QCPAbstractPlottable*>(m_below)})
        curve->addToLegend(m_legend);
    m_marks = new CurveMarks(m_graph);
    m_here = new HereMark(plot, m_rect->axis(QCPAxis::atBottom), m_rect->axis(QCPAxis::atLeft));
    m_runs = new RunGraphs(m_rect->axis(QCPAxis::atBottom), m_rect->axis(QCPAxis::atLeft), m_legend);
    m_runMarks = new RunMarks(plot, m_rect->axis(QCPAxis::atBottom), m_rect->axis(QCPAxis::atLeft));
    m_message = new PlotMessage(plot);
    for (const auto side : {QCPAxis::atBottom, QCPAxis::atLeft}) m_view->watch(m_rect->axis(side));
    connect(plot, &QCustomPlot::afterLayout, this, &GapPlot::placeBands);
    connect(plot, &QCustomPlot::beforeReplot, this, &GapPlot::breakCaption);
    setStyle(PlotStyle::forPaper());
}

void GapPlot::addLegend() {
    auto* header = new QCPLayoutGrid;
    header->setRowSpacing(0);
    m_plot->plotLayout()->addElement(0, 0, header);
    m_plot->plotLayout()->setRowStretchFactor(0, 1e-3);
    m_plot->plotLayout()->setRowSpacing(0);
    m_legend = new QCPLegend;
    m_legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
    m_legend->setMargins(QMargins(7, 6, 0, 0));
    m_caption = new QCPTextElement(m_plot);
    m_caption->setTextFlags(Qt::AlignLeft | Qt::AlignVCenter);
    m_caption->setMargins(QMargins(7, 0, 0, 4));
    header->addElement(0, 0, m_legend);
    header->addElement(1, 0, m_caption);
    m_legend->setLayer(QStringLiteral("legend"));
}

void GapPlot::addRects() {
    m_rect = newRect(m_plot);
    m_beside = newRect(m_plot);
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
    }
    m_rect->axis(QCPAxis::atTop)->setTickLabels(true);
    m_rect->axis(QCPAxis::atRight)->setTicks(false);
    m_beside->axis(QCPAxis::atLeft)->setTickLabels(false);
    m_beside->axis(QCPAxis::atRight)->setTicks(false);
    m_beside->axis(QCPAxis::atTop)->setTickLabels(true);
    m_beside->axis(QCPAxis::atBottom)->ticker()->setTickCount(2);
    auto halves = QSharedPointer<QCPAxisTickerFixed>::create();
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
    QCPAxis* values = m_rect->axis(QCPAxis::atLeft);
    QCPAxis* same = m_beside->axis(QCPAxis::atLeft);
    connect(values, changed, same, [same](const QCPRange& range) { same->setRange(range); });
    connect(same, changed, values, [values](const QCPRange& range) { values->setRange(range); });
    QCPAxis* top = m_rect->axis(QCPAxis::atTop);
    connect(m_rect->axis(QCPAxis::atBottom), changed, this, [this, top](const QCPRange& range) {
        top->setRange(range.lower / m_picture.gap.factor, range.upper / m_picture.gap.factor);
    });
}

void GapPlot::addLines() {
    for (const int side : {0, 1}) {
        QCPAxisRect* rect = side == 0 ? m_rect : m_beside;
        QCPAxis* x = rect->axis(QCPAxis::atBottom);
        QCPAxis* y = rect->axis(QCPAxis::atLeft);
        const auto place = [&](QCPItemPosition& position) {
            position.setAxes(x, y);
            position.setAxisRect(rect);
            position.setTypeX(QCPItemPosition::ptAxisRectRatio);
            position.setTypeY(QCPItemPosition::ptPlotCoords);
        };
        auto* band = m_bands[side] = new QCPItemRect(m_plot);
        band->setLayer(QStringLiteral("background"));
        band->setSelectable(false);
        band->setClipAxisRect(rect);
        place(*band->topLeft);
        place(*band->bottomRight);
        for (QCPItemStraightLine*& line : m_lines[side]) {
            line = new QCPItemStraightLine(m_plot);
            line->setLayer(QStringLiteral("grid"));
            line->setSelectable(false);
            line->setClipAxisRect(rect);
            place(*line->point1);
            place(*line->point2);
        }
        if (side == 0) continue;
        for (QCPItemText*& name : m_lineNames) {
            name = new QCPItemText(m_plot);
            name->setLayer(QStringLiteral("legend"));  // above the curves
            name->setSelectable(false);
            name->setClipAxisRect(rect);
            name->setPadding(QMargins(4, 1, 4, 1));
            name->setPositionAlignment(Qt::AlignRight | Qt::AlignVCenter);
            place(*name->position);
        }
    }
    m_bandName = new QCPItemText(m_plot);
    m_bandName->setSelectable(false);
    m_bandName->setText(tr("super rebound, e > 1"));
    m_bandName->setPadding(QMargins(6, 3, 6, 3));
    m_bandName->setPositionAlignment(Qt::AlignHCenter | Qt::AlignTop);
    m_bandName->setClipAxisRect(m_rect);
    m_bandName->position->setAxes(m_rect->axis(QCPAxis::atBottom), m_rect->axis(QCPAxis::atLeft));
    m_bandName->position->setAxisRect(m_rect);
    m_bandName->position->setTypeX(QCPItemPosition::ptAxisRectRatio);
    m_bandName->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    m_bandName->position->setCoords(0.5, 0);
}

void GapPlot::present(const GapPicture& picture) {
    const bool otherAxes = !m_picture.curve || !sameAxes(m_picture, picture);
    m_picture = picture;
    m_message->hide();
    setFramesVisible(true);
    m_graph->setData(picture.curve);
    m_graph->setName(gapOutputName(picture.output));
    m_rect->axis(QCPAxis::atLeft)
        ->setLabel(picture.value.unit.isEmpty() ? gapOutputName(picture.output)
                                                : picture.value.axisLabel(gapOutputName(picture.output)));
    m_rect->axis(QCPAxis::atBottom)->setLabel(picture.gap.axisLabel(tr("gap d")));
    QCPAxis* top = m_rect->axis(QCPAxis::atTop);
    top->setTickLabels(!picture.gap.dimensionless);
    top->setLabel(picture.gap.dimensionless ? QString() : tr("δ = gap / d₀"));
    m_shares->data()->set(curveData(picture.shares), true);
    m_below->data()->set(curveData(picture.below), true);
    showSpread();
    if (m_view->isFitted() || otherAxes) fit();
    m_marks->present(picture.marks, picture.gap, picture.value);
}

void GapPlot::showNothing(const QString& message) {
    m_picture = {};
    m_graph->data()->clear();
    m_shares->data()->clear();
    m_below->data()->clear();
    m_runs->present({});
    m_runMarks->present({});
    m_marks->clear();
    m_here->setPlace({}, {});
    m_caption->setText({});
    m_summary = message;
    m_message->show(message);
    setFramesVisible(false);
    showSpread();
}

// Axes of nothing would only be behind the message.
void GapPlot::setFramesVisible(bool visible) {
    for (const QCPAxisRect* rect : {m_rect, m_beside})
        for (QCPAxis* axis : rect->axes()) axis->setVisible(visible);
    m_legend->setVisible(visible);
}

void GapPlot::setHere(const std::optional<QPointF>& place) {
    if (place)
        m_here->setPlace(place->x(), place->y());
    else
        m_here->setPlace({}, {});
}

void GapPlot::setRuns(const QVector<RunCurve>& curves, const QVector<RunMark>& marks) {
    m_legend->setWrap(3);  // as many as fit beside each other with their names
    m_runs->present(curves);
    m_runMarks->present(marks);
    if (m_view->isFitted()) fit();
}

// 5 %, mean and 95 %, through both rects.
void GapPlot::showSpread() {
    const bool isShown = m_picture.curve && m_picture.marks.size() > 0;
    const GapSpread& spread = m_picture.spread;
    const double values[] = {spread.quantiles.front().value, spread.mean.value,
                             spread.quantiles.back().value};
    const QString names[] = {tr("5 %"), tr("mean"), tr("95 %")};
    for (int i = 0; i < 3; ++i) {
        const double at = values[i] * m_picture.value.factor;
        for (const auto& side : m_lines) {
            side[i]->setVisible(isShown);
            side[i]->point1->setCoords(0, at);
            side[i]->point2->setCoords(1, at);
        }
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
                               : tr("all gaps alike: mean %1, 5–95 % %2…%3"))
            .arg(shown(spread.mean), shown(spread.quantiles.front()), shown(spread.quantiles.back()));
    if (m_picture.shareAboveOne)
        text += tr(" · e > 1 at %1 of gaps").arg(percentText(*m_picture.shareAboveOne, locale));
    if (m_picture.thrust)
        text += tr(" · thrust for 95 % of gaps %1")
                    .arg(numberText(*m_picture.thrust, 4, locale) + QChar(QChar::Nbsp) +
                         m_picture.thrustUnit.unit);
    return text;
}

// Above 1, as far as that is in view: files do not clip.
void GapPlot::placeBands() {
    const QCPRange view = m_rect->axis(QCPAxis::atLeft)->range();
    const bool isShown = m_picture.curve && m_picture.output == GapOutput::cor && view.upper > 1;
    for (QCPItemRect* band : m_bands) {
        band->setVisible(isShown);
        band->topLeft->setCoords(0, view.upper);
        band->bottomRight->setCoords(1, std::max(1.0, view.lower));
    }
    m_bandName->setVisible(isShown);
}

void GapPlot::setStyle(const PlotStyle& style) {
    m_style = style;
    m_message->setStyle(style);
    m_plot->setBackground(style.background);
    for (QCPAxisRect* rect : {m_rect, m_beside}) style.applyTo(*rect);
    m_beside->axis(QCPAxis::atTop)->grid()->setVisible(false);
    style.applyTo(*m_legend);
    style.applyTo(*m_caption);
    m_graph->setPen(style.linePen(0));
    m_shares->setPen(QPen(style.lines[0], 1));
    m_shares->setBrush(style.areaBrush(0));
    m_below->setPen(style.linePen(1));
    for (QCPItemRect* band : m_bands) {
        band->setPen(Qt::NoPen);
        band->setBrush(style.areaBrush(2));
    }
    for (const auto& side : m_lines)
        for (int i = 0; i < 3; ++i)
            side[i]->setPen(QPen(style.zeroLine, 1, i == 1 ? Qt::DashDotLine : Qt::DashLine));
    QColor behind = style.background;
    behind.setAlpha(190);
    for (QCPItemText* name : {m_lineNames[0], m_lineNames[1], m_lineNames[2], m_bandName}) {
        name->setFont(style.font);
        name->setColor(style.text);
    }
    for (QCPItemText* name : m_lineNames) name->setBrush(behind);
    m_marks->setStyle(style);
    m_here->setStyle(style);
    m_runs->setStyle(style);
    m_runMarks->setStyle(style);
    if (!m_picture.curve) return;
    showSpread();  // files have another locale
    m_marks->present(m_picture.marks, m_picture.gap, m_picture.value);
}

KeyPlaces GapPlot::keyPlaces() const {
    KeyPlaces places;
    places.rect = m_rect;
    places.start = [this] { return m_here->place(); };
    places.marks = [this] {
        QVector<QPointF> marks;
        for (const CurveMark& mark : m_picture.marks) marks.append(mark.at);
        return m_graph->visible() ? marks : QVector<QPointF>();
    };
    return places;
}

void GapPlot::fit() {
    m_view->fit([&] {
        const double room = 0.02 * (m_picture.to - m_picture.from);
        m_rect->axis(QCPAxis::atBottom)->setRange(m_picture.from - room, m_picture.to + room);
        bool found = false;
        QCPRange values = m_graph->getValueRange(found);
        if (!found) values = {0, 1};
        for (QCPGraph* run : m_runs->graphs()) {
            bool isThere = false;
            const QCPRange range = run->getValueRange(isThere);
            if (isThere) values.expand(range);
        }
        const double size = std::max(values.size(), 0.02 * std::abs(values.upper));
        // Where super rebound begins, if that leaves the curves most of the height.
        constexpr double share = 0.25;
        const bool isNear = values.upper > 1 - share * size && values.lower < 1 + share * size;
        if (m_picture.output == GapOutput::cor && isNear) values.expand(1);
        m_rect->axis(QCPAxis::atLeft)->setRange(values.lower - 0.1 * size, values.upper + 0.1 * size);
        const auto shares = m_shares->getKeyRange(found);
        m_beside->axis(QCPAxis::atBottom)->setRange(0, found && shares.upper > 0 ? 1.05 * shares.upper : 100);
        m_beside->axis(QCPAxis::atTop)->setRange(0, 105);
    });
}

}  // namespace drillwave
