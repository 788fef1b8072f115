// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/field_text.h"

#include "core/text/handy_text.h"
#include "ui/text/typed_text.h"

namespace drillwave {
namespace {

constexpr qsizetype exactTextLength = 10;  // longer ones are rounded for display
constexpr int displayDigits = 6;

}  // namespace

QString fieldText(double si, Quantity quantity, const Unit& unit, const QLocale& locale) {
    const QString exact = QString::fromStdString(formatQuantity(si, quantity, unit));
    const qsizetype end = exact.indexOf(u' ');
    const QString number = end < 0 ? exact : exact.left(end);
    const bool inThisUnit = unit.name.empty() || exact.mid(end + 1).toStdString() == unit.name;
    const bool readable = inThisUnit && number.size() <= exactTextLength;
    return localText(readable ? number : QString::fromStdString(rounded(unit.fromSi(si), displayDigits)),
                     locale);
}

}  // namespace drillwave
