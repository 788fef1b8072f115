// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/wave_picture/rod_profile.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <ranges>

#include "ui/plot/run_pen.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr int leastRows = 4;  // of names at the curves
constexpr int profileMargin = 3;
constexpr int sampleLength = 26;  // of the line before a name [px]
constexpr double room = 1.06;     // above the largest value

/// Returns the units of the picture, for the dimensionless numbers of a run.
PictureUnits unitsOfRun(const WavePicture& now, const Scales& nowScales, const SolvedBlow& run,
                        const ShownUnits& units) {
    PictureUnits own = pictureUnits(run, units);
    if (own.velocity.dimensionless) return own;
    own.velocity = now.units.velocity;
    own.velocity.factor *= run.scales.particleVelocity / nowScales.particleVelocity;
    return own;
}

}  // namespace

RodProfile::RodProfile(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setObjectName(QStringLiteral("profile"));
    hide();
}

QSize RodProfile::sizeHint() const {
    return {600, leastRows * fontMetrics().height() + 2 * profileMargin};
}

void RodProfile::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    compute();
}

void RodProfile::setBlow(const SolvedBlowPtr& blow) {
    m_blow = blow;
    setVisible(m_blow && (picture().string || !picture().runs.empty()));
    if (m_blow)
        setAccessibleName(picture().raster.quantity == WaveQuantity::force
                              ? tr("Force along the rod at the time cursor, of this blow and of pinned runs")
                              : tr("Velocity along the rod at the time cursor, of this blow and of pinned "
                                   "runs"));
    compute();
}

void RodProfile::setTime(double t) {
    if (m_time == t) return;
    m_time = t;
    compute();
}

void RodProfile::setRodEnds(int left, int right) {
    if (m_left == left && m_right == right) return;
    m_left = left;
    m_right = right;
    compute();
}

QRectF RodProfile::area() const {
    const int right = m_right > 0 ? m_right : width() - 2 * m_left;
    return QRectF(m_left, profileMargin, std::max(1, right - m_left),
                  std::max(1, height() - 2 * profileMargin));
}

double RodProfile::pixelOf(double xi) const {
    return area().left() + (xi - picture().rear) / (1 - picture().rear) * area().width();
}

void RodProfile::compute() {
    m_lines.clear();
    if (m_blow && !isHidden()) {
        const WavePicture& now = picture();
        const WaveQuantity field = now.raster.quantity;
        m_limit = now.limit * unit().factor;
        m_lines.append(lineOf(*m_blow, now.units, m_time));
        m_lines.last().title = tr("this blow");
        for (const RunOverlay<RunWaves>& run : now.runs) {
            const auto blow = run.blow.lock();
            if (!blow) continue;  // it is on its way out
            const PictureUnits units = unitsOfRun(now, m_blow->scales, *blow, run.units);
            const double time = m_time * now.units.time.factor / units.time.factor;
            m_limit = std::max(m_limit, run.curves->largest(field) * units.of(field).factor);
            m_lines.append(lineOf(*blow, units, time));
            m_lines.last().number = run.number;
            m_lines.last().title = run.title;
        }
        setAccessibleDescription(readout(0.5));
    }
    update();
}

// Samples every pixel of the screen, over the length of the rod on show, or of hammer and string.
RodProfile::Line RodProfile::lineOf(const SolvedBlow& blow, const PictureUnits& units, double time) const {
    const WaveQuantity field = picture().raster.quantity;
    const double length = picture().units.position.factor;
    const double end = length / units.position.factor;
    const RasterGrid grid{
        picture().rear * end, end, std::max(1, static_cast<int>(area().width())), time, time, 1};
    const WaveRaster raster = BlowWaves(blow).raster(field, grid);
    Line line;
    for (int i = 0; i < grid.columns; ++i) {
        const double value = double(raster.values[grid.index(i, 0)]);
        if (std::isfinite(value))
            line.points.append({grid.xi(i) * units.position.factor, value * units.of(field).factor});
    }
    return line;
}

QString RodProfile::readout(double xi) const {
    if (m_lines.isEmpty()) return {};
    const double x = xi * picture().units.position.factor;
    const double step =
        picture().units.position.factor / std::max(1.0, area().width()) * (1 - picture().rear);
    QString text = tr("x = %1 · t = %2")
                       .arg(quantityText(xi, picture().units.position, locale()),
                            timeText(m_time, picture().interesting, picture().units.time, locale()));
    for (const Line& line : m_lines) {
        const auto after = std::ranges::lower_bound(line.points, x, {}, &QPointF::x);
        const auto at = after == line.points.end() && after != line.points.begin() ? after - 1 : after;
        if (at == line.points.end() || std::abs(at->x() - x) > step) continue;
        text += QStringLiteral("\n%1: %2")
                    .arg(line.title, quantityText(at->y() / unit().factor, unit(), locale()));
    }
    return text;
}

QPen RodProfile::penOf(const Line& line, const PlotStyle& style) const {
    return line.number < 0 ? style.linePen(0) : runPen(line.number, style);
}

void RodProfile::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    if (m_lines.isEmpty()) return;
    const PlotStyle style = PlotStyle::forScreen(palette(), font());
    paintAxes(painter, style);
    paintNames(painter, style);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(area());
    const QRectF box = area();
    // The blow itself last, over the others.
    for (qsizetype i = m_lines.size() - 1; i >= 0; --i) {
        QPolygonF pixels;
        for (const QPointF& point : m_lines[i].points)
            pixels.append({pixelOf(point.x() / picture().units.position.factor),
                           box.center().y() - point.y() / (room * m_limit) * box.height() / 2});
        painter.setPen(penOf(m_lines[i], style));
        painter.drawPolyline(pixels);
    }
}

void RodProfile::paintAxes(QPainter& painter, const PlotStyle& style) const {
    const QRectF box = area();
    painter.setPen(QPen(style.frame, 1));
    painter.drawRect(box.adjusted(-1, 0, 0, 0));
    painter.setPen(QPen(style.zeroLine, 1));
    painter.drawLine(QPointF(box.left(), box.center().y()), QPointF(box.right(), box.center().y()));
    if (picture().string)
        for (const RodStretch& section : picture().string->rod.stretches | std::views::drop(1)) {
            const double x = pixelOf(section.rear);
            painter.drawLine(QPointF(x, box.top()), QPointF(x, box.bottom()));
        }
    painter.setPen(style.text);
    const QString end = numberText(m_limit, 3, locale());
    const QString name =
        picture().raster.quantity == WaveQuantity::force ? QStringLiteral("N") : QStringLiteral("v");
    const QRectF beside(0, box.top(), box.left() - 2 * profileMargin, box.height());
    painter.drawText(beside, Qt::AlignRight | Qt::AlignTop, end);
    painter.drawText(beside, Qt::AlignRight | Qt::AlignVCenter, unit().axisLabel(name));
    painter.drawText(beside, Qt::AlignRight | Qt::AlignBottom, QStringLiteral("−") + end);
}

// Names the curves by letters, as many as have room: the list of runs and the tip have the names.
void RodProfile::paintNames(QPainter& painter, const PlotStyle& style) const {
    const QFontMetrics metrics = fontMetrics();
    const int row = metrics.height();
    const qsizetype rows = std::max(leastRows, static_cast<int>(area().height()) / row);
    double left = area().right() + 2 * profileMargin;
    for (qsizetype first = 0; first < m_lines.size(); first += rows) {
        double widest = 0;
        const qsizetype end = std::min(first + rows, m_lines.size());
        for (qsizetype i = first; i < end; ++i) {
            const Line& line = m_lines[i];
            const QString name = line.number < 0 ? tr("now") : line.title.left(1);
            const double width = metrics.horizontalAdvance(name);
            if (left + sampleLength + profileMargin + width > this->width()) return;
            widest = std::max(widest, width);
            const double y = profileMargin + (double(i - first) + 0.5) * row;
            painter.setPen(penOf(line, style));
            painter.drawLine(QPointF(left, y), QPointF(left + sampleLength, y));
            painter.setPen(style.text);
            painter.drawText(QRectF(left + sampleLength + profileMargin, y - row / 2.0, width + 1, row),
                             Qt::AlignLeft | Qt::AlignVCenter, name);
        }
        left += sampleLength + widest + 4 * profileMargin;
    }
}

bool RodProfile::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip && !m_lines.isEmpty()) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const double share = (help->pos().x() - area().left()) / area().width();
        const double xi = std::lerp(picture().rear, 1, share);
        QToolTip::showText(help->globalPos(),
                           withoutMarkup(share >= 0 && share <= 1 ? readout(xi) : accessibleName()), this);
        return true;
    }
    if (event->type() == QEvent::PaletteChange) update();
    return QWidget::event(event);
}

}  // namespace drillwave
