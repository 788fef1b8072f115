// SPDX-License-Identifier: GPL-3.0-or-later
// Formatting of numbers for display.
#pragma once

#include <QLocale>
#include <QString>

#include "ui/text/shown_units.h"

namespace drillwave {

/// Text for a missing number.
inline const QString noNumber = QStringLiteral("–");

/// Returns the locale without group separators: "12345" instead of "12.345" or "12,345", which could be read
/// as a decimal number.
QLocale withoutGroups(QLocale locale);

/// Returns a number with `digits` significant digits and no trailing zeros: "0.4067", "−0.4067" with a minus
/// sign. Below a million it has all digits before the point, "12345"; above, and below 1e-4, a power of ten,
/// "1.235·10⁷".
QString numberText(double value, int digits, const QLocale& locale);

/// Returns the `text` of a number with "+" added in front if `value` is positive.
QString withSign(double value, const QString& text);

/// Returns a fraction in per cent with `digits` significant digits: "12.3 %" for 0.123.
QString percentText(double share, int digits, const QLocale& locale);

/// Returns the order of magnitude of a value with one digit, "3·10⁻¹⁵"; "0" for zero.
QString magnitudeText(double value, const QLocale& locale);

/// Returns an upper limit ≥ 0, such as that of an error, rounded up to one digit: "4·10⁻¹⁵" for 3.2e-15.
QString boundText(double bound, const QLocale& locale);

/// Returns a dimensionless value converted to `unit`, or to a unit with a more suitable prefix: "187.3 kN",
/// "36.06 N".
QString quantityText(double value, const ShownUnit& unit, const QLocale& locale);

/// Returns a computing time, given in seconds: "3 µs", "12 ms".
QString runTimeText(double seconds, const QLocale& locale);

}  // namespace drillwave
