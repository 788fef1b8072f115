// SPDX-License-Identifier: GPL-3.0-or-later
// Results as text for people.
#pragma once

#include <QLocale>
#include <QString>

#include "ui/text/shown_units.h"

namespace drillwave {

/// Text for a missing number.
inline const QString noNumber = QStringLiteral("–");

/// The locale, writing "12345" for "12.345" and "12,345": a group separator of one is the decimal sign of
/// another.
QLocale withoutGroups(QLocale locale);

/// Formats significant digits without trailing zeros: "0.4067", "−0.4067" with a real minus sign; all digits
/// before the point up to a million, "12345", without group separators; "1.235·10⁷" beyond.
QString numberText(double value, int digits, const QLocale& locale);

/// The text of a number with its sign: "+" before that of a positive one.
QString withSign(double value, const QString& text);

/// A share of 1 in so many digits: "12.3 %".
QString percentText(double share, int digits, const QLocale& locale);

/// Order of magnitude with one digit, "3·10⁻¹⁵"; "0" for zero.
QString magnitudeText(double value, const QLocale& locale);

/// A bound ≥ 0 with one digit, not smaller than it is: "4·10⁻¹⁵" for 3.2e-15.
QString boundText(double bound, const QLocale& locale);

/// A dimensionless value in the unit it is shown in, or with a prefix that reads better: "187.3 kN", "36.06
/// N".
QString quantityText(double value, const ShownUnit& unit, const QLocale& locale);

/// A duration of the program itself: "3 µs", "12 ms".
QString runTimeText(double seconds, const QLocale& locale);

}  // namespace drillwave
