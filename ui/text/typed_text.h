// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as users type and read them in the window, with the locale's decimal sign, converted to and from C
// text.
#pragma once

#include <QLocale>
#include <QString>
#include <string_view>

#include "core/text/units.h"

namespace drillwave {

/// Typed text in a form that parseQuantity() reads, or the reason why its number cannot be read.
struct PlainText {
    QString text;
    QString problem;
};

/// Returns a text such as "3,2 m", "7 850 kg/m³" or "1.234,5" with a point as the decimal sign and no
/// grouping. The locale's decimal sign is always accepted. The other of point and comma is accepted too,
/// unless it could also group thousands ("1,500" in a locale with a point), which is refused.
PlainText plainText(const QString& typed, const QLocale& locale);

/// Number at the beginning of a text, without a sign.
struct LeadingNumber {
    QString text;          ///< number with a decimal point and no grouping; empty if there is none
    QString problem;       ///< why the number cannot be read
    qsizetype length = 0;  ///< number of characters read
};

/// Returns the number at the beginning of a text, read by the rules of plainText(). Requires that the text
/// has no invisible characters.
LeadingNumber leadingNumber(QStringView text, const QLocale& locale);

/// Returns a text without direction marks, soft hyphens and blanks of no width, which copied text may have.
QString withoutInvisible(QString text);

/// Returns a number in C format ("3.2") with the decimal sign of the locale ("3,2").
QString localText(const QString& plain, const QLocale& locale);

/// Returns the name of a unit as shown: "µs" for "us", "mm²" for "mm^2".
QString shownUnitName(std::string_view name);

// Quantity as an input field shows it: all digits of a short number, six of a long one.

/// Returns the text of an input field: a value, given in SI, converted to `unit`. The unit's name is left
/// out.
QString fieldText(double si, Quantity quantity, const Unit& unit, const QLocale& locale);

}  // namespace drillwave
