// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/string/string_sketch.h"

#include <algorithm>
#include <cmath>

#include "core/model/section_pieces.h"
#include "core/model/section_words.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr double rockShare = 0.012;     // of the length
constexpr double roomAround = 1.45;     // of the largest diameter: room for words above
constexpr double letterShare = 0.0085;  // width of a letter, of that of the picture

}  // namespace

StringSketch::StringSketch(QCustomPlot* plot) : QObject(plot), m_plot(plot), m_style(PlotStyle::forPaper()) {
    plot->axisRect()->setupFullAxesBox(true);
    for (QCPAxis* far : {plot->xAxis2, plot->yAxis2}) far->setTicks(false);
    for (QCPAxis* axis : {plot->xAxis, plot->yAxis}) axis->grid()->setVisible(false);
}

void StringSketch::setStyle(const PlotStyle& style) {
    m_style = style;
    m_plot->setBackground(style.background);
    style.applyTo(*m_plot->axisRect());
}

std::vector<StringSketch::Piece> StringSketch::piecesOf(const SketchedString& shown) {
    const DrillString& drillString = shown.drillString;
    double place = 0;
    for (const Section& section : drillString.hammer.sections) place -= section.length;
    std::vector<Piece> pieces;
    const std::size_t ofHammer = drillString.hammer.sections.size();
    for (const Section* section : allSections(drillString)) {
        const std::size_t number = pieces.size();
        Piece piece;
        piece.isHammer = number < ofHammer;
        piece.rear = shown.length.factor * place;
        place += section->length;
        piece.front = shown.length.factor * place;
        piece.diameter = shown.across.factor * largestDiameter(*section);
        piece.rearDiameter = shown.across.factor * outerDiameterAt(*section, 0);
        piece.frontDiameter = shown.across.factor * outerDiameterAt(*section, 1);
        piece.bore = section->area ? 0 : shown.across.factor * section->bore;
        piece.place = static_cast<int>(piece.isHammer ? number + 1 : number + 1 - ofHammer);
        piece.name = translated(sectionNameMessage(section->name));
        pieces.push_back(piece);
    }
    return pieces;
}

void StringSketch::present(const SketchedString& shown) {
    m_plot->clearItems();
    m_plot->xAxis->setLabel(shown.length.axisLabel(tr("position x from the struck end, hammer at x < 0")));
    m_plot->yAxis->setLabel(shown.across.axisLabel(tr("diameter")));
    const std::vector<Piece> pieces = piecesOf(shown);
    const double largest = std::ranges::max(pieces, {}, &Piece::diameter).diameter;
    const double rear = pieces.front().rear, front = pieces.back().front;
    setScale(rear, front, largest);
    const double rock = rockShare * (front - rear);
    addBar(front, front + rock, largest * roomAround / 2, m_style.text, m_style.text);
    for (const Piece& piece : pieces) addPiece(piece);
    addLine({0, -largest / 2 * 1.1}, {0, largest / 2 * 1.1}, QPen(m_style.text, 2));
    addWords(pieces);
}

// Diameters are read on both sides of the axis.
void StringSketch::setScale(double rear, double front, double largest) {
    const double whole = front - rear;
    m_plot->xAxis->setRange(rear - rockShare * whole, front + 2 * rockShare * whole);
    m_plot->yAxis->setRange(-roomAround * largest / 2, roomAround * largest / 2);
    auto ticks = QSharedPointer<QCPAxisTickerText>::create();
    const double decade = std::pow(10, std::floor(std::log10(largest)));
    const double step = largest / decade >= 4 ? 2 * decade : largest / decade >= 2 ? decade : decade / 2;
    for (int i = 0; i * step <= largest * roomAround; ++i)
        for (const int side : {-1, 1})
            ticks->addTick(side * i * step / 2, numberText(i * step, 3, m_plot->locale()));
    m_plot->yAxis->setTicker(ticks);
}

// Draws the cone as bars finer than can be seen, in its outline.
void StringSketch::addCone(const Piece& piece, const QColor& shade) {
    constexpr int bars = 40;
    const auto at = [](double from, double to, double share) { return std::lerp(from, to, share); };
    for (int i = 0; i < bars; ++i)
        addBar(at(piece.rear, piece.front, i / double(bars)),
               at(piece.rear, piece.front, (i + 1) / double(bars)),
               at(piece.rearDiameter, piece.frontDiameter, (i + 0.5) / bars) / 2, shade, Qt::NoPen);
    const QPen pen(m_style.text, 0.8);
    for (const double side : {-0.5, 0.5})
        addLine({piece.rear, side * piece.rearDiameter}, {piece.front, side * piece.frontDiameter}, pen);
    for (const auto& [x, diameter] :
         {std::pair(piece.rear, piece.rearDiameter), std::pair(piece.front, piece.frontDiameter)})
        addLine({x, -diameter / 2}, {x, diameter / 2}, pen);
}

void StringSketch::addBar(double left, double right, double half, const QBrush& brush, const QPen& pen) {
    auto* bar = new QCPItemRect(m_plot);
    bar->setSelectable(false);
    bar->topLeft->setCoords(left, half);
    bar->bottomRight->setCoords(right, -half);
    bar->setPen(pen.style() == Qt::NoPen ? pen : QPen(pen.color(), 0.8));
    bar->setBrush(brush);
}

void StringSketch::addLine(QPointF from, QPointF to, const QPen& pen) {
    auto* line = new QCPItemLine(m_plot);
    line->setSelectable(false);
    line->start->setCoords(from);
    line->end->setCoords(to);
    line->setPen(pen);
}

void StringSketch::addText(QPointF at, const QString& text) {
    auto* words = new QCPItemText(m_plot);
    words->setSelectable(false);
    words->position->setCoords(at);
    words->setText(text);
    words->setFont(m_style.font);
    words->setColor(m_style.text);
}

void StringSketch::addPiece(const Piece& piece) {
    QColor shade = m_style.text;
    shade.setAlpha(piece.isHammer ? 80 : 24);
    if (piece.rearDiameter == piece.frontDiameter) {
        addBar(piece.rear, piece.front, piece.diameter / 2, shade, m_style.text);
    } else {
        addCone(piece, shade);
    }
    if (!(piece.bore > 0)) return;
    QPen dashes(m_style.text, 0.6, Qt::DashLine);
    for (const double side : {-0.5, 0.5})
        addLine({piece.rear, side * piece.bore}, {piece.front, side * piece.bore}, dashes);
}

// Writes places above the sections, from left to right if they keep clear of each other; names inside.
void StringSketch::addWords(const std::vector<Piece>& pieces) {
    const double letter = letterShare * m_plot->xAxis->range().size();
    double clear = m_plot->xAxis->range().lower;
    const double height = m_plot->yAxis->range().upper * 0.86;
    for (const Piece& piece : pieces) {
        const QString place = piece.isHammer ? tr("h%1").arg(piece.place) : QString::number(piece.place);
        const double middle = (piece.rear + piece.front) / 2;
        const double half = (double(place.size()) + 1) * letter / 2;
        if (middle - half >= clear) {
            addText({middle, height}, place);
            clear = middle + half;
        }
        if (double(piece.name.size() + 2) * letter <= piece.front - piece.rear)
            addText({middle, 0}, piece.name);
    }
}

}  // namespace drillwave
