// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_style.h"

#include <qcustomplot.h>

#include <QFontInfo>
#include <algorithm>
#include <cmath>
#include <typeinfo>

#include "ui/plot/number_ticks.h"
#include "ui/text/lightness.h"

namespace drillwave {
namespace {

QColor blend(const QColor& from, const QColor& to, double share) {
    const auto mix = [share](int a, int b) { return static_cast<int>(std::lround(a + (b - a) * share)); };
    return QColor(mix(from.red(), to.red()), mix(from.green(), to.green()), mix(from.blue(), to.blue()));
}

// Blue, vermilion, green, purple: distinguishable with the common colour vision deficiencies.
constexpr QRgb linesOnLight[PlotStyle::lineKinds] = {0xff0b62a8, 0xffb8430a, 0xff00725a, 0xff86358a};
constexpr QRgb linesOnDark[PlotStyle::lineKinds] = {0xff64b5f6, 0xffff9e64, 0xff4fd1a5, 0xffe39be0};

void setColors(PlotStyle& style, const QColor& background, const QColor& text) {
    style.background = background;
    style.text = text;
    style.frame = blend(background, text, 0.45);
    style.grid = blend(background, text, 0.12);
    style.zeroLine = blend(background, text, 0.35);
    const bool dark = isDark(background);
    std::transform(std::begin(linesOnLight), std::end(linesOnLight), std::begin(linesOnDark), style.lines,
                   [dark](QRgb light, QRgb bright) { return QColor::fromRgb(dark ? bright : light); });
}

// Replaces the ticks that an axis has from the start.
void writeNumbers(QCPAxis& axis) {
    const QSharedPointer<QCPAxisTicker> present = axis.ticker();
    if (const QCPAxisTicker& ticker = *present; typeid(ticker) != typeid(QCPAxisTicker)) return;
    const auto numbers = QSharedPointer<NumberTicks<QCPAxisTicker>>::create();
    numbers->setTickCount(present->tickCount());
    axis.setTicker(numbers);
}

void applyTo(QCPAxis& axis, const PlotStyle& style) {
    writeNumbers(axis);
    axis.setLabelFont(style.font);
    axis.setTickLabelFont(style.font);
    axis.setLabelColor(style.text);
    axis.setTickLabelColor(style.text);
    axis.setBasePen(QPen(style.frame, 1));
    axis.setTickPen(QPen(style.frame, 1));
    axis.setSubTickPen(QPen(style.frame, 1));
    axis.setTickLengthIn(4);
    axis.setSubTickLengthIn(2);
    axis.grid()->setPen(QPen(style.grid, 1));
    axis.grid()->setZeroLinePen(QPen(style.zeroLine, 1));
}

}  // namespace

PlotStyle PlotStyle::forScreen(const QPalette& palette, const QFont& font) {
    PlotStyle style;
    setColors(style, palette.color(QPalette::Base), palette.color(QPalette::Text));
    style.font = font;
    style.font.setPixelSize(std::max(9, QFontInfo(font).pixelSize() - 1));
    return style;
}

PlotStyle PlotStyle::forPaper() {
    PlotStyle style;
    setColors(style, Qt::white, QColor(0x1a, 0x1a, 0x1a));
    // Uses the name of the real font: "Sans Serif" would mean nothing to another program.
    style.font.setFamily(QFontInfo(style.font).family());
    style.font.setPixelSize(12);
    // QCustomPlot draws the line five pixels too long and trusts a clip that SVG does not have.
    style.legendGap = 9;
    return style;
}

QPen PlotStyle::linePen(int index) const {
    static const QList<qreal> dashes[lineKinds] = {{}, {6, 3}, {8, 3, 1.5, 3}, {1.5, 2.5}};
    const int kind = (index + index / lineKinds) % lineKinds;  // of dashes: sixteen pens that differ
    QPen pen(lines[index % lineKinds], lineWidth);
    pen.setCapStyle(Qt::FlatCap);
    pen.setJoinStyle(Qt::BevelJoin);
    if (!dashes[kind].isEmpty()) pen.setDashPattern(dashes[kind]);
    return pen;
}

QPen PlotStyle::ghostPen(int index) const {
    QColor color = lines[index % lineKinds];
    color.setAlpha(170);
    QPen pen(color, 1);
    pen.setDashPattern({3, 2});
    pen.setCapStyle(Qt::FlatCap);
    return pen;
}

QBrush PlotStyle::areaBrush(int index) const {
    QColor color = lines[index % lineKinds];
    color.setAlpha(36);
    return color;
}

QBrush PlotStyle::behindWords() const {
    constexpr int alpha = 190;
    QColor color = background;
    color.setAlpha(alpha);
    return color;
}

void PlotStyle::applyTo(QCPAxisRect& rect) const {
    for (QCPAxis* axis : rect.axes()) drillwave::applyTo(*axis, *this);
}

void PlotStyle::applyTo(QCPLegend& legend) const {
    legend.setFont(font);
    legend.setIconTextPadding(legendGap);
    legend.setTextColor(text);
    legend.setBrush(Qt::NoBrush);
    legend.setBorderPen(Qt::NoPen);
    for (int i = 0; i < legend.itemCount(); ++i) {
        QCPAbstractLegendItem* item = legend.item(i);
        if (!item) continue;  // a cell of the last row that is left over
        item->setFont(font);
        item->setTextColor(text);
    }
}

void PlotStyle::applyTo(QCPTextElement& title) const {
    title.setFont(font);
    title.setTextColor(text);
}

QCPLayer* ghostLayer(QCustomPlot& plot) {
    const QString name = QStringLiteral("ghost");
    if (!plot.layer(name)) plot.addLayer(name, plot.layer(QStringLiteral("main")), QCustomPlot::limBelow);
    return plot.layer(name);
}

}  // namespace drillwave
