// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/axis_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/plot/number_ticks.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr double largestMagnitude = 1e100;
constexpr double leastRelativeSize = 1e-12;
constexpr double mostDecades = 300;
constexpr double mostFittedDecades = 9;
const char* const linearTicker = "drillwave_linear_ticker";

// The smallest and largest number of the visible curves along an axis, and the smallest positive one.
struct Extent {
    double least = std::numeric_limits<double>::infinity();
    double leastPositive = std::numeric_limits<double>::infinity();
    double most = -std::numeric_limits<double>::infinity();

    void add(double number) {
        if (!std::isfinite(number)) return;
        least = std::min(least, number);
        most = std::max(most, number);
        if (number > 0) leastPositive = std::min(leastPositive, number);
    }
};

template <class Points>
void addAll(Extent& extent, const Points& points, bool keys) {
    for (auto point = points.constBegin(); point != points.constEnd(); ++point)
        extent.add(keys ? point->key : point->value);
}

Extent extentOf(const QCPAxis& axis) {
    Extent extent;
    for (const QCPAbstractPlottable* curve : axis.plottables()) {
        if (!curve->realVisibility()) continue;
        const bool keys = curve->keyAxis() == &axis;
        if (const auto* graph = qobject_cast<const QCPGraph*>(curve)) addAll(extent, *graph->data(), keys);
        if (const auto* path = qobject_cast<const QCPCurve*>(curve)) addAll(extent, *path->data(), keys);
    }
    return extent;
}

QCPAxis* oppositeAxis(const QCPAxis& axis) {
    QCPAxis* opposite = axis.axisRect()->axis(QCPAxis::opposite(axis.axisType()));
    return opposite == &axis ? nullptr : opposite;
}

bool isLogarithmic(const QCPAxis& axis) {
    return axis.scaleType() == QCPAxis::stLogarithmic;
}

}  // namespace

QCPRange usableRange(QCPRange wanted, QCPRange present, QCPAxis::ScaleType scale) {
    const double magnitude = std::max(std::abs(wanted.lower), std::abs(wanted.upper));
    // Written so that NaN fails.
    if (!(magnitude <= largestMagnitude && wanted.size() >= leastRelativeSize * magnitude &&
          wanted.size() > 1 / largestMagnitude))
        return present;
    if (scale == QCPAxis::stLinear) return wanted;
    const bool usable = wanted.lower > 0 && std::log10(wanted.upper) - std::log10(wanted.lower) < mostDecades;
    return usable ? wanted : present;
}

void zoomAxis(QCPAxis& axis, double factor, double aroundPixel) {
    const double center = axis.pixelToCoord(aroundPixel);
    const QCPRange range = axis.range();
    const QCPRange zoomed = isLogarithmic(axis) ? QCPRange(center * std::pow(range.lower / center, factor),
                                                           center * std::pow(range.upper / center, factor))
                                                : QCPRange(center + (range.lower - center) * factor,
                                                           center + (range.upper - center) * factor);
    axis.setRange(usableRange(zoomed, range, axis.scaleType()));
}

void panAxis(QCPAxis& axis, QCPRange start, double fromPixel, double toPixel) {
    const double from = axis.pixelToCoord(fromPixel);
    const double to = axis.pixelToCoord(toPixel);
    const QCPRange panned = isLogarithmic(axis)
                                ? QCPRange(start.lower * (from / to), start.upper * (from / to))
                                : QCPRange(start.lower + (from - to), start.upper + (from - to));
    axis.setRange(usableRange(panned, axis.range(), axis.scaleType()));
}

void zoomAxisTo(QCPAxis& axis, double pixel, double otherPixel) {
    const double a = axis.pixelToCoord(pixel);
    const double b = axis.pixelToCoord(otherPixel);
    axis.setRange(usableRange(QCPRange(std::min(a, b), std::max(a, b)), axis.range(), axis.scaleType()));
}

QString reasonAgainstLogarithm(const QCPAxis& axis) {
    const Extent extent = extentOf(axis);
    if (!(extent.most > 0)) return tr("No curve on this axis has positive values.");
    if (extent.least < 0) return tr("Curves on this axis have negative values; hide them first.");
    return {};
}

void setScale(QCPAxis& axis, QCPAxis::ScaleType scale) {
    if (axis.scaleType() == scale) return;
    QList<QCPAxis*> both{&axis};
    if (QCPAxis* opposite = oppositeAxis(axis)) both.append(opposite);
    for (QCPAxis* changed : both) {
        if (scale == QCPAxis::stLogarithmic) {
            changed->setProperty(linearTicker, QVariant::fromValue(changed->ticker()));
            changed->setTicker(QSharedPointer<NumberTicks<QCPAxisTickerLog>>::create());
        } else {
            changed->setTicker(changed->property(linearTicker).value<QSharedPointer<QCPAxisTicker>>());
        }
        changed->setScaleType(scale);
    }
    fitLogarithmic(axis);
}

void fitLogarithmic(QCPAxis& axis) {
    if (!isLogarithmic(axis)) return;
    const Extent extent = extentOf(axis);
    if (!(extent.most > 0)) return;
    const double least = std::max(extent.leastPositive, extent.most * std::pow(10, -mostFittedDecades));
    const double margin = std::max(1.02, std::pow(extent.most / least, 0.04));
    const QCPRange fitted = axis.orientation() == Qt::Horizontal && extent.most > least
                                ? QCPRange(least, extent.most)
                                : QCPRange(least / margin, extent.most * margin);
    axis.setRange(usableRange(fitted, axis.range(), axis.scaleType()));
}

bool setTickCount(QCPAxis& axis) {
    constexpr int least = 3, most = 5;  // with two, only one may be in view, which shows no scale
    constexpr double linesApart = 2;    // between neighbours, of which there may be more than requested
    constexpr double linesAbreast = 3;  // between neighbours side by side
    const bool isAcross = axis.orientation() == Qt::Horizontal;
    const int length = isAcross ? axis.axisRect()->width() : axis.axisRect()->height();
    const double line = QFontMetricsF(axis.tickLabelFont()).height();
    const double apart = (isAcross ? linesAbreast : linesApart) * line;
    const int count = std::clamp(static_cast<int>(length / apart), isAcross ? 2 : least, most);
    if (axis.ticker()->tickCount() == count) return false;
    axis.ticker()->setTickCount(count);
    return true;
}

namespace {

constexpr const char* secondLineProperty = "secondLine";

// Breaks a text at the space that makes its longer line shortest. A text without spaces stays in one line.
QStringList inTwoLines(const QString& text, const QFontMetricsF& metrics) {
    QStringList best{text};
    double least = metrics.horizontalAdvance(text);
    for (qsizetype at = text.indexOf(QLatin1Char(' ')); at > 0; at = text.indexOf(QLatin1Char(' '), at + 1)) {
        const QStringList lines{text.left(at), text.mid(at + 1)};
        const double width =
            std::max(metrics.horizontalAdvance(lines[0]), metrics.horizontalAdvance(lines[1]));
        if (width < least) {
            least = width;
            best = lines;
        }
    }
    return best;
}

}  // namespace

QString labelThatFits(const QCPAxis& axis) {
    constexpr double beyond = 10;  // both ends of a vertical axis [px]
    const QFontMetricsF metrics(axis.labelFont());
    const QRect rect = axis.axisRect()->rect();
    const int middle = rect.center().x();
    const double length = axis.orientation() == Qt::Horizontal
                              ? 2 * std::min(middle, axis.parentPlot()->viewport().right() - middle)
                              : rect.height() + beyond;
    const auto fitted = [&](const QString& line) {
        if (metrics.horizontalAdvance(line) <= length) return line;
        qsizetype tailAt = -1;
        for (const char16_t* tail : {u" [", u" = ", u" ≈ "})
            tailAt = std::max(tailAt, line.lastIndexOf(QString::fromUtf16(tail)));
        const QString tail = tailAt < 0 ? QString() : line.mid(tailAt);
        const QString words =
            metrics.elidedText(line.left(tailAt), Qt::ElideRight, length - metrics.horizontalAdvance(tail));
        return words.size() > 2 ? words + tail : tail.trimmed();
    };
    QStringList lines = axis.label().split(QLatin1Char('\n'));
    if (lines.size() == 1 && fitted(axis.label()) != axis.label()) {
        const QStringList halves = inTwoLines(axis.label(), metrics);
        if (std::ranges::all_of(halves, [&](const QString& line) { return fitted(line) == line; }))
            return halves.join(QLatin1Char('\n'));
    }
    std::ranges::transform(lines, lines.begin(), fitted);
    return lines.join(QLatin1Char('\n'));
}

int secondLine(const QCPAxis& axis) {
    return axis.property(secondLineProperty).toInt();
}

bool reserveSecondLine(QCPAxis& axis, bool isWanted) {
    const int had = secondLine(axis);
    const auto height = [metrics = QFontMetrics(axis.labelFont())](const QString& text) {
        return metrics.boundingRect(0, 0, 0, 0, Qt::TextDontClip, text).height();
    };
    const int room = isWanted ? height(QStringLiteral("X\nX")) - height(QStringLiteral("X")) : 0;
    if (room == had) return false;
    axis.setLabelPadding(axis.labelPadding() - had + room);
    axis.setProperty(secondLineProperty, room);
    return true;
}

void setTickDigits(QCPAxis& axis) {
    if (axis.numberFormat().startsWith(QLatin1Char('e'))) return;  // powers of ten have none
    const QVector<double> ticks = axis.tickVector();
    if (ticks.size() < 2) return;
    const double magnitude = std::max(std::abs(ticks.first()), std::abs(ticks.last()));
    const double step = std::abs(ticks[1] - ticks[0]);
    const bool apart = step > 0 && magnitude > 0 && std::isfinite(magnitude / step);
    const int digits = apart ? static_cast<int>(std::ceil(std::log10(magnitude / step))) + 2 : 6;
    axis.setNumberPrecision(std::clamp(digits, 6, 16));
}

}  // namespace drillwave
