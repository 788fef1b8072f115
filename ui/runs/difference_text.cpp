// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/difference_text.h"

#include <QFileInfo>
#include <QLocale>
#include <QStringList>
#include <cmath>

#include "core/model/assignments.h"
#include "core/model/blow_traits.h"
#include "core/model/chain_words.h"
#include "core/model/section_parameter.h"
#include "core/model/section_words.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"
#include "ui/text/typed_text.h"
#include "ui/text/unit_choice.h"

namespace drillwave {

namespace {

constexpr double rounding = 1e-12;  // of results: a smaller difference is none

constexpr qsizetype mostChanges = 4;  // more are no name

// "k", "blow frequency"; of a section "coupling ⌀", "rod length", "hammer 1 bore".
QString nameWords(const Parameter& parameter, const Scenario& scenario) {
    if (!parameter.address)
        return parameter.symbol.empty() ? parameterLabel(parameter) : shownSymbol(parameter.symbol);
    const SectionAddress& address = *parameter.address;
    const std::string name = sectionName(parameter, scenario);
    const QString section =
        translated(name.empty() ? addressedWords(address, scenario.drillString) : sectionNameMessage(name));
    if (address.field->key == "diameter") return section + QStringLiteral(" ⌀");
    return section + QLatin1Char(' ') + coreText(address.field->label);
}

// "k 300 MN/m", "blow frequency 60 Hz", "coupling ⌀39 mm".
QString valueWords(const Parameter& parameter, const Scenario& scenario, const UnitChoice& units) {
    const QString name = nameWords(parameter, scenario);
    const std::optional<double> si = valueIn(scenario, parameter);
    if (!si) return tr("no %1").arg(name);
    const Unit& unit = units.fieldUnit(parameter);
    const QString value = numberText(unit.fromSi(*si), 4, QLocale());
    const QString unitName = shownUnitName(unit.name);
    const QString gap = name.endsWith(u'⌀') ? QString() : QStringLiteral(" ");
    return name + gap + (unitName.isEmpty() ? value : value + QLatin1Char(' ') + unitName);
}

QString blowWords(const Pulse& pulse) {
    if (pulse.shape == PulseShape::table && !pulse.tableFile.empty())
        return QFileInfo(QString::fromStdString(pulse.tableFile)).fileName();
    return coreName(name(pulse.shape));
}

}  // namespace

std::optional<double> relativeDifference(double value, double reference) {
    if (reference == 0 || !std::isfinite(reference) || !std::isfinite(value)) return std::nullopt;
    const double relative = (value - reference) / std::abs(reference);
    return std::abs(relative) < rounding ? 0 : relative;
}

QString relativeText(double value, double reference) {
    constexpr double mostPercent = 10;  // as a share
    const std::optional<double> relative = relativeDifference(value, reference);
    if (!relative) return {};
    const QLocale locale;
    const QString percent = QString(QChar(QChar::Nbsp)) + QLatin1Char('%');
    if (*relative == 0) return QStringLiteral("±0") + percent;
    if (*relative > mostPercent && reference > 0)
        return QStringLiteral("×") + numberText(value / reference, 3, locale);
    constexpr double leastPercent = 0.01;  // less is hardly a difference, and would be long
    const double share = 100 * *relative;
    if (std::abs(share) < leastPercent) return QStringLiteral("≈0") + percent;
    const int digits = std::abs(share) >= 1 ? 3 : 2;
    return withSign(*relative, numberText(share, digits, locale)) + percent;
}

QString signedText(double difference, int digits) {
    if (difference == 0) return QStringLiteral("±0");
    return withSign(difference, numberText(difference, digits, QLocale()));
}

QString changeWords(const Scenario& before, const Scenario& after, const UnitChoice& units) {
    QStringList changes;
    // All the numbers of one form are new in the other.
    if (!areOfOneKind(before, after)) return translated(chainWords(after).kind);
    if (before.pulse.shape != after.pulse.shape || !(before.pulse.tablePoints == after.pulse.tablePoints))
        changes << blowWords(after.pulse);
    const Scenario* const both[] = {&before, &after};
    for (const KeptParameter& parameter : differingParameters(both))
        if (parameter->applies(after)) changes << valueWords(*parameter, after, units);
    changes.removeDuplicates();  // of sections with one name
    if (changes.size() > mostChanges) changes = changes.mid(0, mostChanges) << QStringLiteral("…");
    return changes.join(QStringLiteral(", "));
}

}  // namespace drillwave
