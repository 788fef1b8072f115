// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_name.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>
#include <QStringList>

#include "core/model/scenario_difference.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"
#include "ui/text/typed_text.h"
#include "ui/text/unit_choice.h"

namespace drillwave {
namespace {

constexpr qsizetype mostChanges = 4;  // more are no name

QString tr(const char* text) {
    return QCoreApplication::translate("drillwave::RunName", text);
}

// "k 300 MN/m", "blow frequency 60 Hz".
QString valueWords(const Parameter& parameter, const Scenario& scenario) {
    const QString name = parameter.symbol.empty() ? fromView(parameter.label) : shownSymbol(parameter.symbol);
    const std::optional<double> si = valueIn(scenario, parameter);
    if (!si) return tr("no %1").arg(name);
    const Unit& unit = UnitChoice::shared().fieldUnit(parameter);
    const QString value = numberText(unit.fromSi(*si), 4, QLocale());
    const QString unitName = shownUnitName(unit.name);
    return name + QLatin1Char(' ') + (unitName.isEmpty() ? value : value + QLatin1Char(' ') + unitName);
}

QString blowWords(const Pulse& pulse) {
    if (pulse.shape == PulseShape::table && !pulse.tableFile.empty())
        return QFileInfo(QString::fromStdString(pulse.tableFile)).fileName();
    return fromView(name(pulse.shape)).replace(u'_', u' ');
}

}  // namespace

QString changeWords(const Scenario& before, const Scenario& after) {
    QStringList changes;
    if (before.pulse.shape != after.pulse.shape || !(before.pulse.tablePoints == after.pulse.tablePoints))
        changes << blowWords(after.pulse);
    const Scenario* const both[] = {&before, &after};
    for (const Parameter* parameter : differingParameters(both))
        if (parameter->applies(after)) changes << valueWords(*parameter, after);
    if (changes.size() > mostChanges) changes = changes.mid(0, mostChanges) << QStringLiteral("…");
    return changes.join(QStringLiteral(", "));
}

}  // namespace drillwave
