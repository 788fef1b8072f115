// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/wave_picture/joint_marks.h"

#include <algorithm>

namespace drillwave {
namespace {

constexpr int plainMargin = 10;          // above the picture [px]
constexpr double namePadding = 3;        // around a name [px]
constexpr double leastJointSpacing = 2;  // of joints that are still drawn [px]
constexpr float jointOpacity = 0.4F, faceOpacity = 0.9F, haloOpacity = 0.9F;

}  // namespace

void JointMarksItem::setBlow(const SolvedBlowPtr& blow) {
    WavePictureItem::setBlow(blow);
    reserveRoom();
}

void JointMarksItem::setStyle(const PlotStyle& style) {
    WavePictureItem::setStyle(style);
    reserveRoom();
}

void JointMarksItem::reserveRoom() {
    QCPAxisRect* axes = parentPlot()->axisRect();
    QMargins margins = axes->minimumMargins();
    const bool hasNames = m_blow && picture().string;
    margins.setTop(hasNames ? static_cast<int>(QFontMetricsF(m_style.font).height() + 2 * namePadding)
                            : plainMargin);
    if (margins != axes->minimumMargins()) axes->setMinimumMargins(margins);
}

QVector<JointMarksItem::Named> JointMarksItem::namedStretches() const {
    QVector<Named> named;
    const std::vector<RodStretch>& stretches = picture().string->rod.stretches;
    for (const RodStretch& stretch : stretches) {
        const bool isHammer = stretch.number < 0;
        const bool goesOn =
            isHammer && stretch.name.isEmpty() && !named.isEmpty() && named.last().text == tr("hammer");
        if (goesOn)
            named.last().front = stretch.front;
        else
            named.append({!stretch.name.isEmpty() ? stretch.name
                          : isHammer              ? tr("hammer")
                                                  : QString::number(stretch.number),
                          stretch.rear, stretch.front});
    }
    return named;
}

QVector<JointMarksItem::Name> JointMarksItem::names() const {
    if (!m_blow || !picture().string) return {};
    QVector<Named> byLength = namedStretches();
    std::ranges::stable_sort(byLength, std::greater(),
                             [](const Named& each) { return each.front - each.rear; });
    const QRectF axes = parentPlot()->axisRect()->rect();
    const QFontMetricsF metrics(m_style.font);
    const double height = metrics.height();
    QVector<Name> names;
    for (const Named& each : std::as_const(byLength)) {
        const double left = std::max(axes.left(), pixel(each.rear, 0).x());
        const double right = std::min(axes.right() + 1, pixel(each.front, 0).x());
        if (!(left < right)) continue;
        const double middle = (left + right) / 2, width = metrics.horizontalAdvance(each.text);
        Name name{each.text, {}, width + 2 * namePadding > right - left};
        if (name.upright)
            name.box = {middle - height / 2, axes.top() + namePadding, height, width + 2 * namePadding};
        else
            name.box = {middle - width / 2, axes.top() - namePadding - height, width, height};
        const double beyond = name.box.right() - axes.right();
        if (name.upright && beyond > 0) name.box.translate(-beyond, 0);
        const bool isFree =
            std::ranges::none_of(names, [&](const Name& other) { return other.box.intersects(name.box); });
        if (isFree && name.box.bottom() < axes.bottom()) names.append(name);
    }
    return names;
}

QVector<double> JointMarksItem::lines() const {
    if (!m_blow || !picture().string) return {};
    const QRectF axes = parentPlot()->axisRect()->rect();
    QVector<double> places;
    const std::vector<RodStretch>& stretches = picture().string->rod.stretches;
    for (std::size_t j = 1; j < stretches.size(); ++j) {
        const double x = pixel(stretches[j].rear, 0).x();
        if (x < axes.left() || x > axes.right() + 1) continue;
        if (places.isEmpty() || x - places.last() >= leastJointSpacing || stretches[j].rear == 0)
            places.append(x);
    }
    return places;
}

void JointMarksItem::draw(QCPPainter* painter) {
    if (!m_blow || !picture().string) return;
    const QRectF axes = parentPlot()->axisRect()->rect();
    QColor colour = m_style.text;
    colour.setAlphaF(jointOpacity);
    painter->setAntialiasing(false);
    painter->setPen(QPen(colour, 1));
    for (const double x : lines()) painter->drawLine(QLineF(x, axes.top(), x, axes.bottom()));
    drawFace(*painter);
    drawNames(*painter);
}

void JointMarksItem::drawFace(QCPPainter& painter) const {
    const QRectF axes = parentPlot()->axisRect()->rect();
    const double x = pixel(0, 0).x();
    if (x < axes.left() || x > axes.right() + 1) return;
    QColor colour = m_style.text;
    colour.setAlphaF(faceOpacity);
    painter.setPen(QPen(colour, 1));
    painter.drawLine(QLineF(x, axes.top(), x, axes.bottom()));
    painter.setPen(QPen(m_style.text, 3, Qt::SolidLine, Qt::FlatCap));
    const RasterGrid range = view();
    for (const ContactInterval& contact : picture().string->faceContacts) {
        if (contact.end < range.timeBegin || contact.begin > range.timeEnd) continue;
        const double bottom = std::min(pixel(0, contact.begin).y(), axes.bottom());
        const double top = std::max(pixel(0, contact.end).y(), axes.top());
        painter.drawLine(QLineF(x, bottom, x, std::min(top, bottom - 1)));
    }
}

void JointMarksItem::drawNames(QCPPainter& painter) const {
    QColor halo = m_style.background;
    halo.setAlphaF(haloOpacity);
    painter.setFont(m_style.font);
    for (const Name& name : names()) {
        if (name.upright) painter.fillRect(name.box, halo);
        painter.setPen(m_style.text);
        painter.save();
        painter.translate(name.box.center());
        const QSizeF size = name.upright ? name.box.size().transposed() : name.box.size();
        if (name.upright) painter.rotate(-90);
        painter.drawText(QRectF(QPointF(-size.width() / 2, -size.height() / 2), size), Qt::AlignCenter,
                         name.text);
        painter.restore();
    }
}

}  // namespace drillwave
