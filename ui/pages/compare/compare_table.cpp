// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/compare/compare_table.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/model/assignments.h"
#include "core/model/blow_traits.h"
#include "core/model/section_parameter.h"
#include "core/text/csv.h"
#include "ui/job/output_text.h"
#include "ui/pages/study/output_box.h"
#include "ui/pages/study/parameter_names.h"
#include "ui/result/feed_text.h"
#include "ui/runs/difference_text.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"
#include "ui/text/typed_text.h"
#include "ui/text/unit_choice.h"

namespace drillwave {
namespace {

using Columns = std::vector<CompareColumn>;

constexpr int digits = 5;

bool isSolved(const CompareColumn& column) {
    return column.blow && column.blow->fault.isEmpty();
}

CompareRow heading(const QString& name) {
    return {.kind = CompareRow::Kind::heading, .name = name, .unit = {}, .numbers = {}, .words = {}};
}

/// Shape and table of the hammer blow, where they differ.
void addBlow(CompareTable& table, const Columns& columns) {
    const Pulse& first = columns.front().scenario->pulse;
    const bool isOther = std::ranges::any_of(columns, [&](const CompareColumn& each) {
        const Pulse& pulse = each.scenario->pulse;
        const bool isWave = isForced(*each.scenario);
        return isWave != isForced(*columns.front().scenario) ||
               (isWave && (pulse.shape != first.shape || !(pulse.tablePoints == first.tablePoints)));
    });
    if (!isOther) return;
    CompareRow row{.kind = CompareRow::Kind::parameter,
                   .name = tr("hammer blow"),
                   .unit = {},
                   .numbers = {},
                   .words = {}};
    for (const CompareColumn& each : columns) {
        const Pulse& pulse = each.scenario->pulse;
        row.words << (!isForced(*each.scenario) ? tr("elastic hammer")
                      : pulse.tableFile.empty() ? coreName(name(pulse.shape))
                                                : QString::fromStdString(pulse.tableFile));
    }
    table.rows.push_back(std::move(row));
}

/// "diameter of 1st to 3rd coupling": as the page String calls the section.
QString nameIn(const Parameter& parameter, const std::vector<const Scenario*>& scenarios) {
    for (const Scenario* scenario : scenarios)
        if (parameter.address && hasSectionFor(parameter, *scenario))
            return parameterTitle(parameter, *scenario);
    return parameterName(parameter);
}

/// More rows of sections, of hammer and string together, would push the results out of sight.
constexpr std::ptrdiff_t mostSectionRows = 12;

bool isOfSection(const KeptParameter& parameter) {
    return parameter->address || parameter->key == "string.repeat";
}

void addParameters(CompareTable& table, const std::vector<const Scenario*>& scenarios,
                   const std::vector<KeptParameter>& parameters, const UnitChoice& fields) {
    for (const KeptParameter& parameter : parameters) {
        const Unit& unit = fields.fieldUnit(*parameter);
        CompareRow row{.kind = CompareRow::Kind::parameter,
                       .name = nameIn(*parameter, scenarios),
                       .unit = shownUnitName(unit.name),
                       .numbers = {},
                       .words = {}};
        for (const Scenario* scenario : scenarios) {
            const std::optional<double> si = valueIn(*scenario, *parameter);
            row.numbers.push_back(si ? std::optional(unit.fromSi(*si)) : std::nullopt);
        }
        table.rows.push_back(std::move(row));
    }
}

/// Returns the unit of a column on show, whose scale `base` has, for numbers of an output.
ShownUnit unitOf(const Output& output, const ShownUnits& units, const Scales& base, double size) {
    if (output.measure == Measure::share || output.measure == Measure::energy)
        return {1, QStringLiteral("%"), false};
    if (output.measure == Measure::number) return {};
    ShownUnit unit = output.measure == Measure::work ? units.energy : outputUnit(output, units, size);
    if (output.isOnlySi() || unit.dimensionless) return unit;
    unit.factor /= output.measure == Measure::work ? base.energy : output.scale(base);
    return unit;
}

void addResults(CompareTable& table, const Columns& columns, UnitSystem system, const ChosenUnits& chosen) {
    const bool isPhysical = system != UnitSystem::dimensionless;
    const auto base = std::ranges::find_if(columns, [=](const CompareColumn& each) {
        return isSolved(each) && (!isPhysical || hasUnits(*each.scenario));
    });
    if (base == columns.end()) return;
    const Scales& scales = base->blow->scales;
    const ShownUnits units = shownUnits(system, scales, chosen);
    for (const Output& output : outputs()) {
        if (output.measure == Measure::error || output.name == "efficiency") continue;  // that is rock_work
        if (output.needsThrustStudy()) continue;                                        // of addMargins()
        CompareRow row{.kind = CompareRow::Kind::result,
                       .name = outputName(output),
                       .unit = {},
                       .numbers = {},
                       .words = {}};
        double size = 0;
        for (const CompareColumn& each : columns) {
            row.hasOtherUnit.push_back(isSolved(each) &&
                                       !haveSameUnit(output, *base->blow, *each.blow, system));
            row.numbers.push_back(each.blow ? comparableNumber(output, *each.blow, system) : std::nullopt);
            size = std::max(size, std::abs(row.numbers.back().value_or(0)));
        }
        const auto isThere = [](const std::optional<double>& number) { return number.has_value(); };
        if (std::ranges::none_of(row.numbers, isThere)) continue;
        const ShownUnit unit = unitOf(output, units, scales, size);
        row.unit = unit.unit;
        for (std::optional<double>& number : row.numbers)
            if (number) *number *= unit.factor;
        table.rows.push_back(std::move(row));
    }
}

/// Adds the margins of the installed thrust, for which rods and hammers are compared.
void addMargins(CompareTable& table, const Columns& columns, UnitSystem system, const ChosenUnits& chosen) {
    const auto base = std::ranges::find_if(
        columns, [](const CompareColumn& each) { return isSolved(each) && each.blow->feed; });
    if (system == UnitSystem::dimensionless || base == columns.end()) return;
    using Numbers = std::vector<std::optional<double>>;
    Numbers ofBlow, needed, ofAllGaps, share;
    for (const CompareColumn& each : columns) {
        const bool isJudged = isSolved(each) && each.blow->feed;
        ofBlow.push_back(isJudged ? thrustMargin(*each.blow) : std::nullopt);
        const bool isOfAllGaps = isJudged && each.ofAllGaps && each.ofAllGaps->isOfAllGaps();
        needed.push_back(isOfAllGaps ? std::optional(each.ofAllGaps->largest().thrust) : std::nullopt);
        const bool isInstalled = ofBlow.back() && needed.back();
        ofAllGaps.push_back(isInstalled ? std::optional(*each.blow->feed->effective() - *needed.back())
                                        : std::nullopt);
        share.push_back(isInstalled ? std::optional(*ofAllGaps.back() / *needed.back()) : std::nullopt);
    }
    const ShownUnit force = outputUnit(*findOutput("thrust"), shownUnits(system, base->blow->scales, chosen),
                                       base->blow->feed->need(ThrustCase::scenario).thrust);
    const auto add = [&](const QString& name, Numbers numbers, const ShownUnit& unit, bool isSigned) {
        const auto isThere = [](const std::optional<double>& number) { return number.has_value(); };
        if (std::ranges::none_of(numbers, isThere)) return;
        for (std::optional<double>& number : numbers)
            if (number) *number *= unit.factor;
        table.rows.push_back({.kind = CompareRow::Kind::result,
                              .name = name,
                              .unit = unit.unit,
                              .numbers = std::move(numbers),
                              .words = {},
                              .isSigned = isSigned});
    };
    add(tr("feed force margin, this blow"), std::move(ofBlow), force, true);
    add(tr("feed force required at every gap"), std::move(needed), force, false);
    add(tr("feed force margin at every gap"), std::move(ofAllGaps), force, true);
    add(tr("feed force margin at every gap"), std::move(share), {100, QStringLiteral("%"), false}, true);
}

std::string cell(const QString& text, char separator) {
    return separator == ',' ? csvCell(text.toStdString()) : text.simplified().toStdString();
}

std::string cell(const std::optional<double>& number) {
    return number ? formatNumber(*number) : std::string();
}

}  // namespace

QString CompareRow::text(std::size_t column, const QLocale& locale) const {
    if (!hasNumbers()) return words.value(static_cast<qsizetype>(column));
    const std::optional<double>& number = numbers[column];
    if (!number) return {};
    const QString text = numberText(*number, digits, locale);
    return isSigned ? withSign(*number, text) : text;
}

std::optional<double> CompareRow::difference(std::size_t column, std::size_t reference) const {
    if (numbers.empty() || !numbers[column] || !numbers[reference]) return std::nullopt;
    if (!hasOtherUnit.empty() && hasOtherUnit[column] != hasOtherUnit[reference]) return std::nullopt;
    return *numbers[column] - *numbers[reference];
}

std::optional<double> CompareRow::relative(std::size_t column, std::size_t reference) const {
    if (!difference(column, reference)) return std::nullopt;
    return relativeDifference(*numbers[column], *numbers[reference]);
}

CompareTable compareTable(const Columns& columns, std::size_t reference, UnitSystem units,
                          const ChosenUnits& chosen, const UnitChoice& fields) {
    CompareTable table;
    table.reference = reference;
    for (const CompareColumn& each : columns) table.titles << each.title;
    table.rows.push_back(heading(tr("differences")));
    addBlow(table, columns);
    std::vector<const Scenario*> scenarios;
    for (const CompareColumn& each : columns) scenarios.push_back(each.scenario);
    std::vector<KeptParameter> differing = differingParameters(scenarios), ofSections;
    if (std::ranges::count_if(differing, isOfSection) > mostSectionRows) {
        const auto rest = std::ranges::stable_partition(differing, std::not_fn(isOfSection));
        ofSections.assign(rest.begin(), rest.end());
        differing.erase(rest.begin(), rest.end());
    }
    addParameters(table, scenarios, differing, fields);
    if (table.rows.size() == 1 && ofSections.empty()) table.rows.front().name = tr("nothing differs");
    if (table.rows.size() == 1 && !ofSections.empty()) table.rows.clear();
    table.rows.push_back(heading(tr("results")));
    addMargins(table, columns, units, chosen);
    addResults(table, columns, units, chosen);
    if (ofSections.empty()) return table;
    table.rows.push_back(heading(tr("sections that differ")));
    addParameters(table, scenarios, ofSections, fields);
    return table;
}

QByteArray compareText(const CompareTable& table, char separator) {
    if (table.titles.isEmpty()) return {};
    std::string text = cell(tr("quantity"), separator) + separator + cell(tr("unit"), separator);
    const auto count = static_cast<std::size_t>(table.titles.size());
    const QString reference = table.titles[static_cast<qsizetype>(table.reference)];
    for (const QString& title : table.titles) text += separator + cell(title, separator);
    for (std::size_t i = 0; i < count; ++i) {
        if (i == table.reference) continue;
        const QString title = table.titles[static_cast<qsizetype>(i)];
        text += separator + cell(tr("(%1) − (%2)").arg(title, reference), separator);
        text += separator + cell(tr("((%1) − (%2)) / |%2| [%]").arg(title, reference), separator);
    }
    text += '\n';
    for (const CompareRow& row : table.rows) {
        if (row.kind == CompareRow::Kind::heading) continue;
        text += cell(row.name, separator) + separator + cell(row.unit, separator);
        for (std::size_t i = 0; i < count; ++i)
            text += separator + (row.hasNumbers() ? cell(row.numbers[i])
                                                  : cell(row.words[static_cast<qsizetype>(i)], separator));
        for (std::size_t i = 0; i < count; ++i) {
            if (i == table.reference) continue;
            const std::optional<double> relative = row.relative(i, table.reference);
            text += separator + cell(row.difference(i, table.reference));
            text += separator + cell(relative ? std::optional(100 * *relative) : std::nullopt);
        }
        text += '\n';
    }
    return QByteArray::fromStdString(text);
}

}  // namespace drillwave
