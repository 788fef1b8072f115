// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/number_text.h"

#include <cmath>

#include "core/text/handy_text.h"

namespace drillwave {
namespace {

QString superscript(int exponent) {
    static const QString digits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    QString text = exponent < 0 ? QStringLiteral("⁻") : QString();
    for (const QChar digit : QString::number(std::abs(exponent))) text += digits[digit.digitValue()];
    return text;
}

}  // namespace

QLocale withoutGroups(QLocale locale) {
    locale.setNumberOptions(locale.numberOptions() | QLocale::OmitGroupSeparator);
    return locale;
}

QString numberText(double value, int digits, const QLocale& locale) {
    const QLocale plain = withoutGroups(locale);
    const double magnitude = std::abs(value);
    QString text;
    if (value != 0 && (magnitude < 1e-4 || magnitude >= 1e6) && std::isfinite(value)) {
        const QStringList parts = QString::number(value, 'e', digits - 1).split(QLatin1Char('e'));
        text = plain.toString(parts[0].toDouble(), 'f', digits - 1) + QStringLiteral("·10") +
               superscript(parts[1].toInt());
    } else if (magnitude >= std::pow(10, digits) - 0.5) {
        text = plain.toString(value, 'f', 0);  // 'g' would write 12345 as 1.235e+04
    } else {
        text = plain.toString(value, 'g', digits);
    }
    return text.replace(QLatin1Char('-'), QStringLiteral("−"));
}

QString withSign(double value, const QString& text) {
    return value > 0 ? QLatin1Char('+') + text : text;
}

QString percentText(double share, int digits, const QLocale& locale) {
    return numberText(100 * share, digits, locale) + QChar(QChar::Nbsp) + QLatin1Char('%');
}

QString magnitudeText(double value, const QLocale& locale) {
    if (value == 0) return QStringLiteral("0");
    int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
    double mantissa = std::round(value / std::pow(10, exponent));
    if (std::abs(mantissa) >= 10) {  // 9.6 is 1·10¹
        mantissa /= 10;
        ++exponent;
    }
    return numberText(mantissa, 1, locale) + QStringLiteral("·10") + superscript(exponent);
}

QString boundText(double bound, const QLocale& locale) {
    return magnitudeText(roundedTo(bound, 1, Rounding::up), locale);
}

QString quantityText(double value, const ShownUnit& unit, const QLocale& locale) {
    const ShownUnit best = readable(unit, value);
    return numberText(value * best.factor, 4, locale) + QChar(QChar::Nbsp) + best.unit;
}

QString runTimeText(double seconds, const QLocale& locale) {
    const auto text = [&locale](double value, const QString& unit) {
        return numberText(value, value < 10 ? 2 : 3, locale) + QChar(QChar::Nbsp) + unit;
    };
    if (seconds < 1e-3) return text(seconds * 1e6, QStringLiteral("µs"));
    return seconds < 1 ? text(seconds * 1e3, QStringLiteral("ms")) : text(seconds, QStringLiteral("s"));
}

}  // namespace drillwave
