// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/rod/strength_lines.h"

#include <algorithm>

#include "ui/plot/axis_rect.h"
#include "ui/text/shown_text.h"

namespace drillwave {

void StrengthLines::addLines(QCPAxisRect* rect) {
    m_rect = rect;
    for (QCPItemStraightLine*& line : m_lines) line = addLevel(rect);
}

void StrengthLines::addName(QCPItemText* name) {
    m_name = name;
    setAcross(*name->position);
}

std::optional<double> RodStretch::*StrengthLines::ofStretch() const {
    return m_kind == Kind::yield ? &RodStretch::yieldStrength : &RodStretch::fatigueStrength;
}

std::vector<double> StrengthLines::values(const RodCurves& curves) const {
    std::vector<double> values;
    const auto add = [&](const std::optional<double>& value) {
        if (value) values.push_back(*value);
    };
    add(m_kind == Kind::yield ? curves.yieldStrength : curves.fatigueStrength);
    if (curves.string)
        for (const RodStretch& stretch : curves.string->stretches)
            add(curves.shownStrength(stretch.*ofStretch()));
    return values;
}

void StrengthLines::clear() {
    showSteps({});
    place({}, {}, {});
}

// Neighbours of one strength have one line.
void StrengthLines::showSteps(const RodCurves& curves) {
    for (QCPItemLine* step : std::as_const(m_steps)) m_rect->parentPlot()->removeItem(step);
    m_steps.clear();
    if (!curves.string || !curves.string->waves) return;
    const std::vector<RodStretch>& stretches = curves.string->stretches;
    const double length = curves.units.length.factor;
    const auto strength = ofStretch();
    for (std::size_t from = 0, to = 0; from < stretches.size(); from = to) {
        for (to = from + 1; to < stretches.size() && stretches[to].*strength == stretches[from].*strength;)
            ++to;
        if (!(stretches[from].*strength)) continue;
        const double shown = *curves.shownStrength(stretches[from].*strength);
        for (const double sign : {1.0, -1.0}) {
            if (sign < 0 && !isOfBoth()) continue;
            auto* step = addItem<QCPItemLine>(m_rect);
            step->start->setCoords(stretches[from].rear * length, sign * shown);
            step->end->setCoords(stretches[to - 1].front * length, sign * shown);
            step->setPen(m_pen);
            m_steps.append(step);
        }
    }
}

void StrengthLines::showName(const RodCurves& curves, const StressText& stress) {
    if (curves.string) return placeOverLongest(curves, stress);
    place(curves, m_kind == Kind::yield ? curves.yieldStrength : curves.fatigueStrength, stress);
}

void StrengthLines::place(const RodCurves& curves, const std::optional<double>& value,
                          const StressText& stress) {
    setLevel(*m_lines[0], value);
    setLevel(*m_lines[1], value && isOfBoth() ? std::optional(-*value) : std::nullopt);
    m_name->setVisible(value.has_value());
    if (!value) return;
    m_name->setText((isOfBoth() ? drillwave::tr("yield strength %1") : drillwave::tr("fatigue strength %1"))
                        .arg(stress(*value)));
    m_name->position->setTypeX(QCPItemPosition::ptAxisRectRatio);
    // The name is on the side where the rod has less tension.
    const bool pulledAtRight = curves.largest(Load::tension).section > 0.5;
    m_name->setPositionAlignment((pulledAtRight ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignBottom);
    m_name->position->setCoords(pulledAtRight ? 0 : 1, *value);
}

// Returns the longest section that has the strength.
const RodStretch* StrengthLines::longest(const RodCurves& curves) const {
    const auto strength = ofStretch();
    const RodStretch* longest = nullptr;
    for (const RodStretch& stretch : curves.string->stretches) {
        if (!(stretch.*strength)) continue;
        if (!longest || stretch.front - stretch.rear > 1.001 * (longest->front - longest->rear))
            longest = &stretch;
    }
    return longest;
}

PlacedLabel StrengthLines::label(const RodCurves& curves) const {
    PlacedLabel label{m_name, {}};
    if (!m_name->visible()) return label;
    const RodStretch* over = curves.string ? longest(curves) : nullptr;
    const double length = curves.units.length.factor;
    const double left = over ? over->rear * length : 0, right = over ? over->front * length : 1;
    struct Side {
        double share;
        Qt::AlignmentFlag alignment;
    };
    // First where it is put without regard to the curves.
    std::vector<Side> sides{{0, Qt::AlignLeft}, {0.5, Qt::AlignHCenter}, {1, Qt::AlignRight}};
    std::ranges::stable_partition(
        sides, [&](const Side& side) { return m_name->positionAlignment() & side.alignment; });
    const double height = m_name->position->value();
    for (const Qt::AlignmentFlag beside : {Qt::AlignBottom, Qt::AlignTop})
        for (const Side& side : sides)
            label.places.append(
                [name = m_name, side, beside, height, x = left + side.share * (right - left)] {
                    name->setPositionAlignment(side.alignment | beside);
                    name->position->setCoords(x, height);
                });
    return label;
}

void StrengthLines::placeOverLongest(const RodCurves& curves, const StressText& stress) {
    place(curves, {}, stress);
    const auto strength = ofStretch();
    const RodStretch* longest = this->longest(curves);
    const bool differ = std::ranges::any_of(curves.string->stretches, [&](const RodStretch& stretch) {
        return stretch.*strength && stretch.*strength != longest->*strength;
    });
    m_name->position->setTypeX(longest ? QCPItemPosition::ptPlotCoords : QCPItemPosition::ptAxisRectRatio);
    m_name->setVisible(longest);
    if (!longest) return;
    const double shown = *curves.shownStrength(longest->*strength);
    if (differ)
        m_name->setText(isOfBoth() ? drillwave::tr("yield strengths") : drillwave::tr("fatigue strengths"));
    else
        m_name->setText(
            (isOfBoth() ? drillwave::tr("yield strength %1") : drillwave::tr("fatigue strength %1"))
                .arg(stress(shown)));
    m_name->setPositionAlignment(Qt::AlignHCenter | Qt::AlignBottom);
    m_name->position->setCoords((longest->rear + longest->front) / 2 * curves.units.length.factor, shown);
}

void StrengthLines::setStyle(const PlotStyle& style) {
    m_pen = QPen(style.text, 1, m_kind == Kind::yield ? Qt::DashDotLine : Qt::DotLine);
    for (QCPItemStraightLine* line : m_lines) line->setPen(m_pen);
    for (QCPItemLine* step : std::as_const(m_steps)) step->setPen(m_pen);
    m_name->setBrush(style.behindWords());
}

}  // namespace drillwave
