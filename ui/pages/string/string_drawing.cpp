// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/string/string_drawing.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "core/model/scales.h"
#include "core/model/section_pieces.h"
#include "ui/text/number_text.h"
#include "ui/text/typed_text.h"
#include "ui/text/unit_choice.h"

namespace drillwave {
namespace {

constexpr double sideMargin = 14;   // [px]
constexpr double groundWidth = 16;  // [px]
constexpr double leastHeight = 70;  // of the thickest section [px]
constexpr double mostHeight = 190;  // of the thickest section [px]
constexpr double clickReach = 4;    // of a click beside a section that is thinner than the pointer [px]

// 1, 2 or 5 times a power of ten, about a seventh of the whole.
double tickStep(double whole) {
    const double decade = std::pow(10, std::floor(std::log10(whole / 7)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (whole / (factor * decade) <= 7) return factor * decade;
    return 10 * decade;
}

}  // namespace

StringDrawing::StringDrawing(const StringModel& model, const UnitChoice& units, QWidget* parent)
    : QWidget(parent), m_model(model), m_units(units) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setMaximumHeight(minimumSizeHint().height() + int(mostHeight - leastHeight));
    setAccessibleName(tr("Drawing of hammer and string"));
    const auto redraw = qOverload<>(&QWidget::update);
    connect(&model, &QAbstractItemModel::dataChanged, this, redraw);
    connect(&model, &QAbstractItemModel::modelReset, this, redraw);
}

// Height of the parts around the sections: title and words above, the ruler and the colours below.
double StringDrawing::wordsHeight() const {
    return 4.6 * fontMetrics().lineSpacing() + 22;
}

QSize StringDrawing::minimumSizeHint() const {
    return {300, int(leastHeight + wordsHeight())};
}

QSize StringDrawing::sizeHint() const {
    return {700, minimumSizeHint().height()};
}

void StringDrawing::setRow(int row) {
    m_row = row;
    update();
}

double StringDrawing::totalLength() const {
    const std::vector<ChainSection>& chain = m_model.chain();
    return chain.empty() ? 0 : chain.back().start + m_model.rows()[chain.back().row].section.length;
}

double StringDrawing::hammerLength() const {
    for (const ChainSection& section : m_model.chain())
        if (!m_model.rows()[section.row].spot.inHammer) return section.start;
    return totalLength();
}

double StringDrawing::largestDiameter() const {
    double largest = 0;
    for (const StringRow& row : m_model.rows())
        largest = std::max(largest, drillwave::largestDiameter(row.section));
    return largest;
}

// Returns the room for the whole length, around the axis.
QRectF StringDrawing::area() const {
    const double top = 2 * fontMetrics().lineSpacing() + 12;
    const double tall = std::max(leastHeight / 2, height() - wordsHeight());
    return {sideMargin, top, std::max(10.0, width() - 2 * sideMargin - groundWidth), tall};
}

double StringDrawing::exaggeration() const {
    if (m_model.chain().empty()) return 0;
    return area().height() / largestDiameter() / (area().width() / totalLength());
}

QRectF StringDrawing::sectionRect(std::size_t section) const {
    const ChainSection& at = m_model.chain()[section];
    const Section& it = m_model.rows()[at.row].section;
    const QRectF whole = area();
    const double scale = whole.width() / totalLength();
    const double tall = whole.height() * drillwave::largestDiameter(it) / largestDiameter();
    return {whole.left() + at.start * scale, whole.center().y() - tall / 2, it.length * scale, tall};
}

// Returns the nearest section if several are thinner than the pointer.
std::optional<std::size_t> StringDrawing::sectionAt(QPointF point) const {
    std::optional<std::size_t> nearest;
    double distance = clickReach;
    for (std::size_t i = 0; i < m_model.chain().size(); ++i) {
        const QRectF rect = sectionRect(i).adjusted(0, -clickReach, 0, clickReach);
        if (point.y() < rect.top() || point.y() > rect.bottom()) continue;
        if (point.x() >= rect.left() && point.x() < rect.right()) return i;
        const double away = std::min(std::abs(point.x() - rect.left()), std::abs(point.x() - rect.right()));
        if (away >= distance) continue;
        distance = away;
        nearest = i;
    }
    return nearest;
}

QString StringDrawing::textOf(std::size_t section) const {
    const ChainSection& at = m_model.chain()[section];
    const StringRow& row = m_model.rows()[at.row];
    const QLocale locale;
    QStringList lines{QStringLiteral("<b>%1</b>").arg(row.nameAt(at.place).toHtmlEscaped())};
    if (const SolvedBlowPtr& blow = m_model.blow(); blow && m_model.results()) {
        const double impedance = propertiesOf(row.section, blow->scenario.drillString.material).impedance;
        lines << tr("impedance Z %1 kN s/m").arg(numberText(impedance / 1e3, 4, locale));
        const SectionStress& stress = m_model.results()->sections[section];
        const auto text = [this](const StressPeak& peak) {
            return m_model.peakText({peak.stress, peak.place, peak.time});
        };
        lines << tr("largest tension %1").arg(text(stress.tension));
        lines << tr("largest compression %1").arg(text(stress.compression));
        if (stress.tensionAfter.stress > 0)
            lines << tr("after the blow, tension %1").arg(text(stress.tensionAfter));
        if (stress.compressionAfter.stress > 0)
            lines << tr("after the blow, compression %1").arg(text(stress.compressionAfter));
    }
    return lines.join(QStringLiteral("<br>"));
}

const ColourScale& StringDrawing::colours() const {
    return ColourScale::forBackground(palette().color(QPalette::Base));
}

// Tension is positive.
QColor StringDrawing::colour(double stress) const {
    const double largest = m_model.results() ? m_model.results()->largest : 0;
    return largest > 0 ? QColor::fromRgb(colours().colour(stress / largest))
                       : palette().color(QPalette::Base);
}

void StringDrawing::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    if (m_model.chain().empty()) return;
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t i = 0; i < m_model.chain().size(); ++i) drawSection(painter, i);
    drawMarks(painter);
    drawRuler(painter);
    drawLegend(painter);
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1, Qt::DotLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(1, 1, -2, -2));
    }
}

void StringDrawing::drawSection(QPainter& painter, std::size_t section) const {
    const QRectF rect = sectionRect(section);
    const StringRow& row = m_model.rows()[m_model.chain()[section].row];
    const double middle = rect.center().y(),
                 across = rect.height() / 2 / drillwave::largestDiameter(row.section);
    const double rear = across * outerDiameterAt(row.section, 0),
                 front = across * outerDiameterAt(row.section, 1);
    const QPolygonF outline({{rect.left(), middle - rear},
                             {rect.right(), middle - front},
                             {rect.right(), middle + front},
                             {rect.left(), middle + rear}});
    // tension above the axis, compression below it
    const auto half = [&](double side) {
        QPainterPath path;
        path.addPolygon(QPolygonF({{rect.left(), middle},
                                   {rect.right(), middle},
                                   {rect.right(), middle + side * front},
                                   {rect.left(), middle + side * rear}}));
        return path;
    };
    const SectionStress none;
    const SectionStress& stress = m_model.results() ? m_model.results()->sections[section] : none;
    painter.fillPath(half(-1), colour(stress.tension.stress));
    painter.fillPath(half(1), colour(-stress.compression.stress));
    const QColor ink = palette().color(QPalette::Text);
    // The hammer by its hatching, in whatever colours.
    if (row.spot.inHammer) {
        QColor hatch = ink;
        hatch.setAlpha(110);
        QPainterPath whole;
        whole.addPolygon(outline);
        painter.fillPath(whole, QBrush(hatch, Qt::BDiagPattern));
    }
    if (!row.section.area && row.section.bore > 0) {
        QColor axis = ink;
        axis.setAlpha(120);
        painter.setPen(QPen(axis, 1, Qt::DashDotLine));
        painter.drawLine(QPointF(rect.left(), rect.center().y()), QPointF(rect.right(), rect.center().y()));
    }
    const bool chosen = static_cast<int>(m_model.chain()[section].row) == m_row;
    painter.setPen(QPen(ink, 0.8));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(outline);
    if (!chosen) return;
    // Marks it not only by colour: a thicker frame, and a bar below that thin sections have, too.
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2.4));
    painter.drawPolygon(outline);
    const double y = area().bottom() + 5;
    painter.drawLine(QPointF(rect.left(), y), QPointF(std::max(rect.right(), rect.left() + 3), y));
}

// The names at both ends, where hammer and string meet, and the rock.
void StringDrawing::drawMarks(QPainter& painter) const {
    const QRectF whole = area();
    const QColor ink = palette().color(QPalette::Text);
    painter.setPen(QPen(ink, 1));
    const QRectF rock(whole.right(), whole.top() - 4, groundWidth, whole.height() + 8);
    painter.fillRect(rock, QBrush(ink, Qt::DiagCrossPattern));
    painter.drawLine(rock.topLeft(), rock.bottomLeft());
    const double x = whole.left() + hammerLength() / totalLength() * whole.width();
    painter.setPen(QPen(ink, 1.6));
    painter.drawLine(QPointF(x, whole.top() - 6), QPointF(x, whole.bottom() + 2));
    const double line = fontMetrics().lineSpacing();
    const QRectF words(whole.left(), whole.top() - 6 - line, whole.width() + groundWidth, line);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, tr("hammer"));
    painter.drawText(words, Qt::AlignRight | Qt::AlignVCenter, tr("rock"));
    const double hammerEnd = std::max(x, whole.left() + fontMetrics().horizontalAdvance(tr("hammer")) + 10);
    painter.drawText(QRectF(hammerEnd + 4, words.top(), whole.right() - hammerEnd, line),
                     Qt::AlignLeft | Qt::AlignVCenter, tr("string"));
}

// Draws lengths from the shank, as the places of stresses are printed.
void StringDrawing::drawRuler(QPainter& painter) const {
    const QRectF whole = area();
    const Unit& unit = m_units.unitFor(UnitKind::length, 1);
    const double length = unit.fromSi(totalLength()), before = unit.fromSi(hammerLength());
    if (!(length > 0)) return;
    const double y = whole.bottom() + 9;
    const double step = tickStep(length);
    painter.setPen(QPen(palette().color(QPalette::Text), 1));
    painter.drawLine(QPointF(whole.left(), y), QPointF(whole.right(), y));
    const double line = fontMetrics().lineSpacing();
    constexpr double rounding = 1e-9;
    const int first = -static_cast<int>(before / step + rounding);
    for (int i = first; i * step <= (length - before) * (1 + rounding); ++i) {
        const double x = whole.left() + (before + i * step) / length * whole.width();
        painter.drawLine(QPointF(x, y), QPointF(x, y + 4));
        const QString text = numberText(i * step, 4, QLocale());
        const QString named = i == 0 ? text + QLatin1Char(' ') + shownUnitName(unit.name) : text;
        const double half = fontMetrics().horizontalAdvance(named) / 2.0 + 2;
        const double center = std::clamp(x, half, width() - half);
        painter.drawText(QRectF(center - half, y + 4, 2 * half, line), Qt::AlignCenter, named);
    }
}

// Draws the exaggeration of diameters above, and the meaning of the colours below.
void StringDrawing::drawLegend(QPainter& painter) const {
    const double line = fontMetrics().lineSpacing();
    const QLocale locale;
    painter.setPen(palette().color(QPalette::Text));
    const QRectF above(sideMargin, 3, width() - 2 * sideMargin, line);
    const QString scaled = tr("Lengths to scale, diameters × %1").arg(numberText(exaggeration(), 2, locale));
    const QString halves = scaled + tr("; upper half tension, lower half compression");
    // The colours below have the same meaning as those of the halves.
    painter.drawText(above, Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().horizontalAdvance(halves) <= above.width() ? halves : scaled);
    if (!m_model.results()) return;
    const SolvedBlow& blow = *m_model.blow();
    const QString largest =
        quantityText(m_model.results()->largest / blow.scales.stress, blow.units.stress, locale);
    const QString left = tr("compression %1").arg(largest);
    const QString right = tr("tension %1").arg(largest);
    const double leftWidth = fontMetrics().horizontalAdvance(left);
    const double y = height() - line - 4;
    constexpr double usualBar = 140, leastBar = 20;
    const double besideBar = 2 * sideMargin + leftWidth + fontMetrics().horizontalAdvance(right) + 12;
    const double bar = std::clamp(width() - besideBar, leastBar, usualBar);
    const QRectF scale(sideMargin + leftWidth + 6, y + 2, bar, line - 4);
    painter.drawText(QRectF(sideMargin, y, leftWidth + 1, line), Qt::AlignVCenter, left);
    painter.drawText(QRectF(scale.right() + 6, y, width(), line), Qt::AlignVCenter, right);
    for (int x = 0; x < int(bar); ++x)
        painter.fillRect(QRectF(scale.left() + x, scale.top(), 1.5, scale.height()),
                         QColor::fromRgb(colours().colour(2 * (x + 0.5) / bar - 1)));
    painter.setPen(QPen(palette().color(QPalette::Text), 0.8));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(scale);
}

void StringDrawing::choose(int row) {
    setRow(row);
    emit rowChosen(row);
}

void StringDrawing::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
    if (const std::optional<std::size_t> section = sectionAt(event->position()))
        choose(static_cast<int>(m_model.chain()[*section].row));
}

void StringDrawing::keyPressEvent(QKeyEvent* event) {
    const int last = m_model.rowCount() - 1;
    if (last < 0) return QWidget::keyPressEvent(event);
    switch (event->key()) {
        case Qt::Key_Left:
            return choose(std::max(m_row - 1, 0));
        case Qt::Key_Right:
            return choose(std::min(m_row + 1, last));
        case Qt::Key_Home:
            return choose(0);
        case Qt::Key_End:
            return choose(last);
        default:
            return QWidget::keyPressEvent(event);
    }
}

bool StringDrawing::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    if (const std::optional<std::size_t> section = sectionAt(help->pos()))
        QToolTip::showText(help->globalPos(), textOf(*section), this,
                           sectionRect(*section).toAlignedRect().adjusted(-2, -2, 2, 2));
    else
        QToolTip::hideText();
    return true;
}

void StringDrawing::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    update();
}

void StringDrawing::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    update();
}

}  // namespace drillwave
