// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/parameter_tip.h"

#include <QLocale>
#include <cmath>

#include "core/model/parameter.h"
#include "ui/text/core_text.h"
#include "ui/text/field_text.h"
#include "ui/text/shown_text.h"
#include "ui/text/translation.h"
#include "ui/text/typed_text.h"

namespace drillwave {
namespace {

QString withUnit(const QString& number, const Unit& unit) {
    return unit.name.empty() ? number : number + QChar(QChar::Nbsp) + shownUnitName(unit.name);
}

// An end that is no end is told in words.
QString hardText(const Range& range, Quantity quantity, const Unit& unit) {
    const auto text = [&](double si) { return fieldText(si, quantity, unit, QLocale()); };
    if (!std::isfinite(range.high))
        return range.lowOpen ? tr("greater than %1").arg(text(range.low))
                             : tr("at least %1").arg(text(range.low));
    const QString low =
        range.lowOpen ? tr("above %1").arg(text(range.low)) : tr("from %1").arg(text(range.low));
    const QString high = withUnit(text(range.high), unit);
    return range.highOpen ? tr("%1 to below %2").arg(low, high) : tr("%1 to %2").arg(low, high);
}

}  // namespace

ParameterTip tipOf(const Parameter& parameter, const Unit& shown) {
    const auto text = [&](double si) { return fieldText(si, parameter.quantity, shown, QLocale()); };
    const Range& usual = parameter.plausible;
    const QString title = parameterTitle(parameter);
    const QString meaning = coreText(parameter.meaning) + u'.';
    const QString ranges = tr("Range: %1; usual: %2 – %3.")
                               .arg(hardText(parameter.hard, parameter.quantity, shown), text(usual.low),
                                    withUnit(text(usual.high), shown));
    return {.html = QStringLiteral("<p><b>%1</b><br>%2</p><p>%3<br>%4</p>")
                        .arg(title.toHtmlEscaped(), meaning.toHtmlEscaped(), ranges.toHtmlEscaped(),
                             tr("F1: its place in the manual.")),
            .plain = meaning + u' ' + ranges};
}

}  // namespace drillwave
