// SPDX-License-Identifier: GPL-3.0-or-later
// Axis ticks with numbers in the format of numberText().
#pragma once

#include <qcustomplot.h>

#include "ui/text/number_text.h"

namespace drillwave {

/// Ticker of QCustomPlot whose labels have a true minus sign and no group separators, because "1.000" would
/// mean 1 in English. Powers of ten keep "e" and the hyphen in every language, because QCustomPlot recognises
/// powers by them.
template <class Ticker>
class NumberTicks : public Ticker {
  protected:
    QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
        const QLocale plain = withoutGroups(locale);
        const QString minus = QStringLiteral("−");
        QString label = Ticker::getTickLabel(tick, plain, format, precision);
        const qsizetype power = label.indexOf(plain.exponential(), 0, Qt::CaseInsensitive);
        if (power > 0)
            label = label.left(power) + QLatin1Char('e') +
                    label.mid(power + plain.exponential().size()).replace(minus, QStringLiteral("-"));
        if (label.startsWith(QLatin1Char('-'))) label.replace(0, 1, minus);
        return label;
    }
};

}  // namespace drillwave
