// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/wave_picture/wave_picture_items.h"

#include <algorithm>
#include <cmath>

namespace drillwave {
namespace {

constexpr double leastFrontSpacing = 8;  // of fronts that are still drawn [px]
constexpr double leastSpacingOfNames = 60;
constexpr int namedWaves = 8;
constexpr int barGap = 4, barWidth = 9;  // beside the axes [px]

// Digits as subscripts: N₀ₚ, N₁ₙ, N₂ₚ …
QString waveName(int number) {
    return QStringLiteral("N%1%2").arg(QChar(0x2080 + number)).arg(QChar(number % 2 == 0 ? 0x209A : 0x2099));
}

}  // namespace

RasterGrid WavePictureItem::view() const {
    const QCPRange x = parentPlot()->xAxis->range(), y = parentPlot()->yAxis->range();
    const PictureUnits& units = picture().units;
    const QRect rect = parentPlot()->axisRect()->rect();
    return {x.lower / units.position.factor, x.upper / units.position.factor, rect.width(),
            y.lower / units.time.factor,     y.upper / units.time.factor,     rect.height()};
}

QPointF WavePictureItem::pixel(double xi, double t) const {
    const PictureUnits& units = picture().units;
    return {parentPlot()->xAxis->coordToPixel(xi * units.position.factor),
            parentPlot()->yAxis->coordToPixel(t * units.time.factor)};
}

void WaveFieldItem::setBlow(const SolvedBlowPtr& blow) {
    WavePictureItem::setBlow(blow);
    m_image = blow ? imageOf(picture().raster) : QImage();
}

void WaveFieldItem::setStyle(const PlotStyle& style) {
    WavePictureItem::setStyle(style);
    m_colours = ColourScale::forBackground(style.background);
    if (m_blow) m_image = imageOf(picture().raster);
}

// Late times are at the top.
QImage WaveFieldItem::imageOf(const WaveRaster& raster) const {
    const RasterGrid& grid = raster.grid;
    QImage image(grid.columns, grid.rows, QImage::Format_ARGB32_Premultiplied);
    const double scale = 1 / picture().limit;
    for (int row = 0; row < grid.rows; ++row) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(grid.rows - 1 - row));
        const float* values = raster.values.data() + grid.index(0, row);
        std::transform(values, values + grid.columns, line,
                       [&](float value) { return m_colours.colour(value * scale); });
    }
    return image;
}

void WaveFieldItem::draw(QCPPainter* painter) {
    if (!m_blow) return;
    if (painter->modes().testFlag(QCPPainter::pmNoCaching)) return drawForFile(*painter);
    const RasterGrid range = view(), grid = picture().raster.grid;
    const bool current = range.xiBegin == grid.xiBegin && range.xiEnd == grid.xiEnd &&
                         range.timeBegin == grid.timeBegin && range.timeEnd == grid.timeEnd;
    const QRectF axes(parentPlot()->axisRect()->rect());
    if (current) return painter->drawImage(axes, m_image);
    // The picture of another view stays, scaled, until that of the present one has been computed: the part of
    // it in view, for after a strong zoom the whole would be larger than what a painter can take.
    const QRectF whole(pixel(grid.xiBegin, grid.timeEnd), pixel(grid.xiEnd, grid.timeBegin));
    const QRectF shown = whole & axes;
    if (!(shown.width() > 0 && shown.height() > 0)) return;  // NaN as well
    const double across = m_image.width() / whole.width(), down = m_image.height() / whole.height();
    painter->drawImage(shown, m_image,
                       QRectF((shown.left() - whole.left()) * across, (shown.top() - whole.top()) * down,
                              shown.width() * across, shown.height() * down));
}

void WaveFieldItem::drawForFile(QCPPainter& painter) const {
    constexpr double vectorScale = 3;  // device pixels for each of the layout, where the format has none
    const double scale =
        painter.modes().testFlag(QCPPainter::pmVectorized) ? vectorScale : painter.transform().m11();
    RasterGrid grid = view();
    const double fewer =
        std::min(1.0, std::sqrt(mostPictureCells / (scale * scale * grid.columns * grid.rows)));
    grid.columns = std::max(1, int(std::lround(grid.columns * scale * fewer)));
    grid.rows = std::max(1, int(std::lround(grid.rows * scale * fewer)));
    const WaveRaster raster = BlowWaves(*m_blow).raster(picture().raster.quantity, grid);
    painter.drawImage(QRectF(parentPlot()->axisRect()->rect()), imageOf(raster));
}

void WaveFrontsItem::draw(QCPPainter* painter) {
    if (!m_blow) return;
    const double spacing = std::abs(pixel(0, BlowWaves(*m_blow).roundTrip()).y() - pixel(0, 0).y());
    if (!(spacing >= leastFrontSpacing)) return;
    painter->setBrush(Qt::NoBrush);
    QColor colour = m_style.text;
    colour.setAlpha(150);
    const std::vector<double>& fronts = picture().fronts;
    const bool isCrowded = spacing < leastFrontSpacing * double(fronts.size());
    for (std::size_t i = 0; i < fronts.size() && (i == 0 || !isCrowded); ++i) {
        QPen pen(colour, 1, i == 0 ? Qt::SolidLine : Qt::DashLine);
        painter->setPen(pen);
        drawFamily(*painter, fronts[i], i == 0 && spacing >= leastSpacingOfNames);
    }
}

// Draws the front that leaves the hammer at `start`, to and fro.
void WaveFrontsItem::drawFamily(QCPPainter& painter, double start, bool named) const {
    const RasterGrid range = view();
    // Every joint of a string reflects waves: they have no numbers.
    const bool hasNames = named && !picture().string && !m_blow->problem.force().isRigidBody();
    for (const FrontRun& run : BlowWaves(*m_blow).frontRuns(start, range.timeBegin, range.timeEnd)) {
        drawLine(painter, run);
        if (hasNames && run.number < namedWaves) drawName(painter, run);
    }
}

void WaveFrontsItem::drawLine(QCPPainter& painter, const FrontRun& run) const {
    const RasterGrid range = view();
    const double one = run.sectionAt(range.timeBegin), other = run.sectionAt(range.timeEnd);
    const double from = std::max({run.rear, range.xiBegin, std::min(one, other)});
    const double to = std::min({run.front, range.xiEnd, std::max(one, other)});
    if (!(from < to)) return;
    painter.drawLine(QLineF(pixel(from, run.timeAt(from)), pixel(to, run.timeAt(to))));
}

// Draws the name in the middle of the rod, ahead of the front.
void WaveFrontsItem::drawName(QCPPainter& painter, const FrontRun& run) const {
    const bool toBit = run.heading == Heading::toBit;
    const double xi = toBit ? 0.6 : 0.4;
    const QPointF place = pixel(xi, run.timeAt(xi));
    const QString name = waveName(static_cast<int>(run.number));
    const QSizeF size = QFontMetricsF(m_style.font).size(0, name);
    const QRectF box(place.x() + (toBit ? 5 : -5 - size.width()), place.y() + 3, size.width(), size.height());
    if (!QRectF(parentPlot()->axisRect()->rect()).contains(box)) return;
    painter.setFont(m_style.font);
    const QPen pen = painter.pen();
    painter.setPen(m_style.text);
    painter.drawText(box, Qt::AlignCenter, name);
    painter.setPen(pen);
}

void ContactBarsItem::draw(QCPPainter* painter) {
    if (!m_blow) return;
    drawTitle(*painter);
    const RasterGrid range = view();
    const QRectF axes = parentPlot()->axisRect()->rect();
    const std::vector<ContactInterval>& contacts = picture().contacts;
    const auto first =
        std::lower_bound(contacts.begin(), contacts.end(), range.timeBegin,
                         [](const ContactInterval& contact, double t) { return contact.end < t; });
    const double left = axes.right() + barGap;
    double drawnFrom = axes.bottom() + 2;  // upward; bars of less than a pixel are drawn once
    painter->setFont(m_style.font);
    const double digits = QFontMetricsF(m_style.font).capHeight();
    double numberedFrom = axes.bottom() + digits;
    for (auto contact = first; contact != contacts.end() && contact->begin <= range.timeEnd; ++contact) {
        const double bottom = std::min(pixel(1, contact->begin).y(), axes.bottom());
        const double top = std::max(pixel(1, contact->end).y(), axes.top());
        if (drawnFrom - top < 1 && bottom - top < 1) continue;
        drawnFrom = top;
        const QRectF bar(left, top, barWidth, std::max(1.0, bottom - top));
        painter->setPen(Qt::NoPen);
        painter->setBrush(m_style.text);
        painter->drawRect(bar);
        if (contacts.size() == 1) continue;  // a number would say nothing
        const double baseline = bar.center().y() + digits / 2;
        if (baseline > numberedFrom) continue;
        numberedFrom = baseline - 1.5 * digits;
        painter->setPen(m_style.text);
        const QString number = QString::number(contact - contacts.begin() + 1);
        painter->drawText(QPointF(bar.right() + 3, baseline), number);
    }
    drawEvents(*painter, range);
}

// Draws ticks where the rock unloads, and where its force returns to the primary line.
void ContactBarsItem::drawEvents(QCPPainter& painter, const RasterGrid& range) const {
    const QRectF axes = parentPlot()->axisRect()->rect();
    const std::vector<ImpactEvent>& events = m_blow->impact.events;
    const auto first = std::lower_bound(events.begin(), events.end(), range.timeBegin,
                                        [](const ImpactEvent& event, double t) { return event.time < t; });
    const double left = axes.right() + barGap;
    double last = axes.bottom() + 4;
    painter.setPen(QPen(m_style.background, 1.5));
    for (auto event = first; event != events.end() && event->time <= range.timeEnd; ++event) {
        const double y = pixel(1, event->time).y();
        if (event->kind == ContactEvent::contact || event->kind == ContactEvent::separation || last - y < 3)
            continue;
        last = y;
        if (event->kind == ContactEvent::unloading)
            painter.drawLine(QLineF(left, y, left + barWidth, y));
        else
            painter.drawLine(QLineF(left + barWidth / 2.0, y, left + barWidth, y));
    }
}

void ContactBarsItem::drawTitle(QCPPainter& painter) const {
    const QRectF axes = parentPlot()->axisRect()->rect();
    painter.save();
    painter.setFont(m_style.font);
    painter.setPen(m_style.text);
    const double length = axes.height();
    painter.translate(axes.right() + width, axes.center().y());
    painter.rotate(-90);
    const double height = QFontMetricsF(m_style.font).height();
    painter.drawText(QRectF(-length / 2, -height, length, height), Qt::AlignCenter, tr("bit touches rock"));
    painter.restore();
}

}  // namespace drillwave
