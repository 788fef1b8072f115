// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/gap/gap_marks.h"

#include <algorithm>

#include "ui/text/number_text.h"

namespace drillwave {
namespace {

constexpr int mostNamedKinks = 6;

QString wordsOf(const GapMark& mark, const GapPicture& picture, const QLocale& locale) {
    const auto shown = [&](double value, const ShownUnit& unit) {
        const QString number = numberText(value, 4, locale);
        return unit.unit.isEmpty() || unit.dimensionless ? number : number + QChar(QChar::Nbsp) + unit.unit;
    };
    const QString gap = shown(mark.at.x(), picture.gap);
    switch (mark.kind) {
        case GapMark::Kind::extreme:
            return GapMarks::tr("%1 at %2").arg(shown(mark.at.y(), picture.value), gap);
        case GapMark::Kind::crossing:
            return gap;
        case GapMark::Kind::kink:
            break;
    }
    return GapMarks::tr("kink %1").arg(gap);
}

}  // namespace

GapMarks::GapMarks(QCustomPlot* plot, QCPAxisRect* rect)
    : QObject(plot), m_plot(plot), m_rect(rect), m_style(PlotStyle::forPaper()) {}

void GapMarks::present(const GapPicture& picture) {
    clear();
    const auto isKink = [](const GapMark& mark) { return mark.kind == GapMark::Kind::kink; };
    const bool namesKinks = std::ranges::count_if(picture.marks, isKink) <= mostNamedKinks;
    for (const GapMark& mark : picture.marks)
        add(mark, isKink(mark) && !namesKinks ? QString() : wordsOf(mark, picture, m_plot->locale()));
    applyStyle();
}

void GapMarks::clear() {
    for (QCPItemTracer* point : m_points) m_plot->removeItem(point);
    for (QCPItemText* words : m_words) m_plot->removeItem(words);
    m_points.clear();
    m_words.clear();
}

void GapMarks::add(const GapMark& mark, const QString& words) {
    auto* point = new QCPItemTracer(m_plot);
    point->setSelectable(false);
    point->setClipAxisRect(m_rect);
    point->position->setAxes(m_rect->axis(QCPAxis::atBottom), m_rect->axis(QCPAxis::atLeft));
    point->position->setCoords(mark.at);
    point->setStyle(mark.kind == GapMark::Kind::kink ? QCPItemTracer::tsSquare : QCPItemTracer::tsCircle);
    point->setSize(mark.kind == GapMark::Kind::kink ? 5 : 7);
    m_points.append(point);
    if (words.isEmpty()) return;
    auto* text = new QCPItemText(m_plot);
    text->setSelectable(false);
    text->setClipAxisRect(m_rect);
    text->position->setAxes(m_rect->axis(QCPAxis::atBottom), m_rect->axis(QCPAxis::atLeft));
    text->position->setCoords(mark.at);
    text->setPadding(QMargins(7, 4, 7, 4));
    text->setText(words);
    m_words.append(text);
    // Towards the middle of the plot, so that it is not cut off.
    const QCPRange range = m_rect->axis(QCPAxis::atBottom)->range();
    const bool onRight = mark.at.x() > range.center();
    const bool above = mark.kind == GapMark::Kind::extreme ? mark.upper : !mark.upper == onRight;
    text->setPositionAlignment((onRight ? Qt::AlignRight : Qt::AlignLeft) |
                               (above ? Qt::AlignBottom : Qt::AlignTop));
}

void GapMarks::setStyle(const PlotStyle& style) {
    m_style = style;
    applyStyle();
}

void GapMarks::applyStyle() {
    for (QCPItemTracer* point : m_points) {
        point->setPen(QPen(m_style.lines[0], 1.5));
        point->setBrush(m_style.background);
    }
    for (QCPItemText* words : m_words) {
        words->setFont(m_style.font);
        words->setColor(m_style.text);
    }
}

}  // namespace drillwave
