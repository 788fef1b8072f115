// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as users type and read them: their own decimal sign in the window, C text behind it.
#pragma once

#include <QLocale>
#include <QString>
#include <string_view>

#include "core/text/units.h"

namespace drillwave {

/// Text made ready for parseQuantity(), or why its number cannot be understood.
struct PlainText {
    QString text;
    QString problem;
};

/// "3,2 m", "7 850 kg/m³" or "1.234,5" with a point as the decimal sign and no grouping. The locale's own
/// decimal sign always is one; the other sign is taken as one too, except where it could as well group
/// thousands
/// ("1,500" where the point is usual): that is refused, never guessed.
PlainText plainText(const QString& typed, const QLocale& locale);

/// A number at the beginning of a text, without a sign.
struct LeadingNumber {
    QString text;          ///< with a point as the decimal sign and no grouping; empty where there is none
    QString problem;       ///< why it cannot be understood
    qsizetype length = 0;  ///< characters that it takes
};

/// Reads as plainText() does. Requires no invisible characters.
LeadingNumber leadingNumber(QStringView text, const QLocale& locale);

/// Removes direction marks, soft hyphens and blanks of no width, which are in text copied from elsewhere.
QString withoutInvisible(QString text);

/// C text of a number with the locale's decimal sign.
QString localText(const QString& plain, const QLocale& locale);

/// A unit as shown: "µs" for "us", "mm²" for "mm^2".
QString shownUnitName(std::string_view name);

// A quantity as a field for it shows it: all of a short number, six digits of a long one.

/// Formats a value in SI, without the name of the unit.
QString fieldText(double si, Quantity quantity, const Unit& unit, const QLocale& locale);

}  // namespace drillwave
