// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/difference_text.h"

#include <cmath>

#include "ui/text/number_text.h"

namespace drillwave {
namespace {

constexpr double rounding = 1e-12;  // of results: a smaller difference is none

}  // namespace

std::optional<double> relativeDifference(double value, double reference) {
    if (reference == 0 || !std::isfinite(reference) || !std::isfinite(value)) return std::nullopt;
    const double relative = (value - reference) / std::abs(reference);
    return std::abs(relative) < rounding ? 0 : relative;
}

QString relativeText(double value, double reference) {
    constexpr double mostPercent = 10;  // as a share
    const std::optional<double> relative = relativeDifference(value, reference);
    if (!relative) return {};
    const QLocale locale;
    const QString percent = QString(QChar(QChar::Nbsp)) + QLatin1Char('%');
    if (*relative == 0) return QStringLiteral("±0") + percent;
    if (*relative > mostPercent && reference > 0)
        return QStringLiteral("×") + numberText(value / reference, 3, locale);
    constexpr double leastPercent = 0.01;  // less is hardly a difference, and would be long
    const double share = 100 * *relative;
    if (std::abs(share) < leastPercent) return QStringLiteral("≈0") + percent;
    const int digits = std::abs(share) >= 1 ? 3 : 2;
    return withSign(*relative, numberText(share, digits, locale)) + percent;
}

QString signedText(double difference, int digits) {
    if (difference == 0) return QStringLiteral("±0");
    return withSign(difference, numberText(difference, digits, QLocale()));
}

}  // namespace drillwave
