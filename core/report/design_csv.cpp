// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/design_report.h"

#include <algorithm>
#include <numeric>
#include <variant>

#include "core/model/parameter.h"
#include "core/report/design_words.h"
#include "core/report/report_table.h"
#include "core/study/design/constant_energy.h"
#include "core/text/units.h"

namespace drillwave {

namespace {

std::string heading(const Parameter& parameter) {
    return withUnit(parameter.key, &unitsOf(parameter.quantity).front());
}

/// The values that the presets of a choice set, which a table of cases can set, too: those of hammers and
/// rods of uniform rods.
std::vector<std::string_view> presetKeys(const SweepAxis& axis) {
    const bool isOfRod = axis.presets && std::holds_alternative<Preset>(axis.presets->presets().front());
    return isOfRod ? axis.presets->keys() : std::vector<std::string_view>();
}

std::string presetHeading(std::string_view key) {
    const KeptParameter parameter = findParameter(key);
    return parameter ? heading(*parameter) : std::string(key);
}

/// Empty where the preset does not set it.
Cell presetCell(const Preset& preset, std::string_view key) {
    if (key == pulseShapeKey) return preset.shape ? Cell(name(*preset.shape)) : Cell();
    const auto value = std::ranges::find(
        preset.values, key, [](const PresetValue& each) { return std::string_view(each.parameter->key); });
    return value == preset.values.end() ? Cell() : Cell(value->si);
}

/// Parameters that set a design: its choices, and the parameter that keeps the energy. The keys of `without`
/// are left out, to be set otherwise.
std::vector<std::string> designHeadings(const DesignStudy& study, const std::vector<std::string>& without) {
    std::vector<std::string> headings;
    const auto isOut = [&](std::string_view key) { return std::ranges::find(without, key) != without.end(); };
    for (const SweepAxis& axis : study.choices) {
        if (!isOut(axis.key())) headings.push_back(axis.column().header);
        for (const std::string_view key : presetKeys(axis))
            if (!isOut(key)) headings.push_back(presetHeading(key));
    }
    if (!study.keepsEnergy || study.choices.empty()) return headings;
    const KeptParameter scaled = energyParameter(study.base);
    if (!isOut(scaled->key)) headings.push_back(heading(*scaled));
    return headings;
}

Cells designCells(const DesignStudy& study, std::uint64_t design, const std::vector<std::string>& without) {
    Cells cells;
    const auto isOut = [&](std::string_view key) { return std::ranges::find(without, key) != without.end(); };
    const std::vector<double> values = study.choice(design);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const SweepAxis& axis = study.choices[i];
        if (!isOut(axis.key())) cells.push_back(axis.column().cell(values[i]));
        for (const std::string_view key : presetKeys(axis))
            if (!isOut(key))
                cells.push_back(presetCell(
                    std::get<Preset>(axis.presets->presets()[static_cast<std::size_t>(values[i])]), key));
    }
    if (!study.keepsEnergy || study.choices.empty()) return cells;
    const Scenario scenario = designScenario(study, design);
    const KeptParameter scaled = energyParameter(study.base);
    if (!isOut(scaled->key)) cells.push_back(*scaled->value(scenario));
    return cells;
}

std::string headed(const OutputColumn& column, const std::string& suffix) {
    const Unit& unit = unitsOf(column.quantity()).front();
    return withUnit(std::string(column.output->name) + "_" + suffix, column.hasUnit() ? &unit : nullptr);
}

std::vector<std::string> tableHeadings(const DesignStudy& study, const std::vector<OutputColumn>& columns) {
    std::vector<std::string> headings{"number"};
    append(headings, designHeadings(study, {}));
    append(headings, {"feasible", "marginal"});
    for (const OutputColumn& column : columns) {
        headings.push_back(headed(column, "nominal"));
        for (const Statistic& statistic : study.statisticsOf(*column.output)) {
            if (statistic.kind == Statistic::Kind::nominal) continue;
            headings.push_back(headed(column, statistic.name()));
            if (statistic.hasError()) headings.push_back(headed(column, statistic.name() + "_error"));
        }
    }
    append(headings, {"pareto", "marks"});
    return headings;
}

/// Returns rows of the designs of those numbers.
std::string table(const DesignReport& report, const std::vector<std::size_t>& numbers) {
    const DesignStudy& study = report.study;
    const std::vector<OutputColumn> columns = study.columns();
    const std::optional<std::size_t> present = presentDesign(study);
    return csvText({tableHeadings(study, columns), numbers.size(), [&](std::size_t row) {
                        const std::size_t d = numbers[row];
                        const DesignSamples& design = report.findings.designs[d];
                        Cells cells{d + 1};
                        append(cells, designCells(study, d, {}));
                        append(cells, {report.findings.feasibility[d].feasible,
                                       report.findings.feasibility[d].marginal});
                        for (std::size_t c = 0; c < columns.size(); ++c) {
                            cells.push_back(design.nominal[c]);
                            const std::vector<Statistic> asked = study.statisticsOf(*columns[c].output);
                            for (std::size_t s = 0; s < asked.size(); ++s) {
                                if (asked[s].kind == Statistic::Kind::nominal) continue;
                                cells.push_back(design.statistics[c][s].value);
                                if (asked[s].hasError()) cells.push_back(design.statistics[c][s].error());
                            }
                        }
                        std::string marks;
                        for (const std::string_view mark : marksOf(report, d, present))
                            marks += (marks.empty() ? "" : " ") + std::string(mark);
                        append(cells, {bool(report.findings.best.pareto[d]), marks});
                        return cells;
                    }});
}

}  // namespace

std::string designsCsv(const DesignReport& report) {
    std::vector<std::size_t> numbers(report.findings.designs.size());
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    return table(report, numbers);
}

std::string paretoCsv(const DesignReport& report) {
    std::vector<std::size_t> numbers;
    for (std::size_t d = 0; d < report.findings.designs.size(); ++d)
        if (report.findings.best.pareto[d]) numbers.push_back(d);
    return table(report, numbers);
}

std::string sensitivityCsv(const DesignReport& report) {
    const std::vector<OutputSensitivity>& outputs = report.findings.sensitivity.outputs;
    const std::size_t inputs = report.study.dimensions();
    return csvText(
        {{"output", "key", "first", "first_error", "total", "total_error"},
         outputs.size() * inputs,
         [&](std::size_t row) {
             const std::size_t o = row / inputs, i = row % inputs;
             Cells cells{report.findings.aimed[o]->name,
                         i < report.study.uncertain.size()
                             ? std::string_view(report.study.uncertain[i].parameter->key)
                             : "draws"};
             if (outputs[o].isConstant) return cells;
             const SobolIndex& index = outputs[o].indices[i];
             append(cells, {index.first.value, index.first.error, index.total.value, index.total.error});
             return cells;
         }});
}

std::string worstCsv(const DesignReport& report) {
    const DesignStudy& study = report.study;
    std::vector<std::string> keys, headings;
    for (const KeptParameter& parameter : study.scattered()) {
        keys.emplace_back(parameter->key);
        headings.push_back(heading(*parameter));
    }
    append(headings, designHeadings(study, keys));
    append(headings, {"aim", "sense", "value", "sampled", "searches", "agreeing"});
    std::vector<std::size_t> aims;
    for (std::size_t a = 0; a < report.findings.worst.size(); ++a)
        if (report.findings.worst[a]) aims.push_back(a);
    return csvText({headings, aims.size(), [&](std::size_t row) {
                        const auto& aim = study.aims[aims[row]];
                        const WorstCase& worst = *report.findings.worst[aims[row]];
                        Cells cells;
                        for (std::size_t i = 0; i < study.uncertain.size(); ++i) cells.push_back(worst.at[i]);
                        if (study.draws)
                            for (const std::vector<double>& column : study.draws->columns)
                                cells.push_back(column[static_cast<std::size_t>(worst.at.back())]);
                        append(cells, designCells(study, *report.findings.best.robust, keys));
                        append(cells, {aim.name(), aim.sense == Sense::largest ? "min" : "max", worst.value,
                                       worst.sampled, worst.searches, worst.agreeing});
                        return cells;
                    }});
}

}  // namespace drillwave
