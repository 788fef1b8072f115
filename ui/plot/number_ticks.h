// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers along an axis, as numberText() writes them.
#pragma once

#include <qcustomplot.h>

#include "ui/text/number_text.h"

namespace drillwave {

/// Ticks of QCustomPlot without group separators ("1.000" is 1 to who reads it in English) and with a minus
/// sign. A power of ten keeps the "e" and the hyphen by which QCustomPlot knows it, in languages, too, that
/// write neither.
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
