// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/design_csv.h"

#include <algorithm>
#include <variant>

#include "core/model/parameter.h"
#include "core/report/design_words.h"
#include "core/study/design/constant_energy.h"
#include "core/text/csv.h"
#include "core/text/number_text.h"
#include "core/text/unit_heading.h"

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
std::string presetCell(const Preset& preset, std::string_view key) {
    if (key == pulseShapeKey) return preset.shape ? std::string(name(*preset.shape)) : std::string();
    std::string cell;
    for (const PresetValue& value : preset.values)
        if (value.parameter->key == key) appendNumber(cell, value.si);
    return cell;
}

/// What sets a design: its choices, and the parameter that keeps the energy. The keys of `without` are left
/// out, to be set otherwise.
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

std::vector<std::string> designCells(const DesignStudy& study, std::uint64_t design,
                                     const std::vector<std::string>& without) {
    std::vector<std::string> cells;
    const auto isOut = [&](std::string_view key) { return std::ranges::find(without, key) != without.end(); };
    const std::vector<double> values = study.choice(design);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const SweepAxis& axis = study.choices[i];
        if (!isOut(axis.key())) axis.column().appendText(cells.emplace_back(), values[i]);
        for (const std::string_view key : presetKeys(axis))
            if (!isOut(key))
                cells.push_back(presetCell(
                    std::get<Preset>(axis.presets->presets()[static_cast<std::size_t>(values[i])]), key));
    }
    if (!study.keepsEnergy || study.choices.empty()) return cells;
    const Scenario scenario = designScenario(study, design);
    const KeptParameter scaled = energyParameter(study.base);
    if (!isOut(scaled->key)) appendNumber(cells.emplace_back(), *scaled->value(scenario));
    return cells;
}

void addRow(std::string& csv, const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) csv += (i == 0 ? "" : ",") + csvCell(cells[i]);
    csv += '\n';
}

std::string numberCell(double value) {
    std::string cell;
    appendNumber(cell, value);
    return cell;
}

std::string headed(const OutputColumn& column, const std::string& suffix) {
    const Unit& unit = unitsOf(column.quantity()).front();
    return withUnit(std::string(column.output->name) + "_" + suffix, column.hasUnit() ? &unit : nullptr);
}

std::string table(const DesignReport& report, bool paretoAlone) {
    const DesignStudy& study = report.study;
    const std::vector<OutputColumn> columns = study.columns();
    std::vector<std::string> titles{"number"};
    for (std::string& title : designHeadings(study, {})) titles.push_back(std::move(title));
    titles.insert(titles.end(), {"feasible", "marginal"});
    for (const OutputColumn& column : columns) {
        titles.push_back(headed(column, "nominal"));
        for (const Statistic& statistic : study.statisticsOf(*column.output)) {
            if (statistic.kind == Statistic::Kind::nominal) continue;
            titles.push_back(headed(column, statistic.name()));
            if (statistic.hasError()) titles.push_back(headed(column, statistic.name() + "_error"));
        }
    }
    titles.insert(titles.end(), {"pareto", "marks"});
    std::string csv;
    addRow(csv, titles);
    const auto word = [](bool holds) { return std::string(holds ? "true" : "false"); };
    const std::optional<std::size_t> present = presentDesign(study);
    for (std::size_t d = 0; d < report.findings.designs.size(); ++d) {
        if (paretoAlone && !report.findings.best.pareto[d]) continue;
        const DesignSamples& design = report.findings.designs[d];
        std::vector<std::string> cells{std::to_string(d + 1)};
        for (std::string& cell : designCells(study, d, {})) cells.push_back(std::move(cell));
        cells.push_back(word(report.findings.feasibility[d].feasible));
        cells.push_back(word(report.findings.feasibility[d].marginal));
        for (std::size_t c = 0; c < columns.size(); ++c) {
            cells.push_back(numberCell(design.nominal[c]));
            const std::vector<Statistic> asked = study.statisticsOf(*columns[c].output);
            for (std::size_t s = 0; s < asked.size(); ++s) {
                if (asked[s].kind == Statistic::Kind::nominal) continue;
                cells.push_back(numberCell(design.statistics[c][s].value));
                if (asked[s].hasError()) cells.push_back(numberCell(design.statistics[c][s].error()));
            }
        }
        cells.push_back(word(report.findings.best.pareto[d]));
        std::string marks;
        for (const std::string_view mark : marksOf(report, d, present))
            marks += (marks.empty() ? "" : " ") + std::string(mark);
        cells.push_back(marks);
        addRow(csv, cells);
    }
    return csv;
}

}  // namespace

std::string designsCsv(const DesignReport& report) {
    return table(report, false);
}

std::string paretoCsv(const DesignReport& report) {
    return table(report, true);
}

std::string sensitivityCsv(const DesignReport& report) {
    std::string csv = "output,key,first,first_error,total,total_error\n";
    for (std::size_t o = 0; o < report.findings.sensitivity.outputs.size(); ++o) {
        const OutputSensitivity& output = report.findings.sensitivity.outputs[o];
        for (std::size_t i = 0; i < report.study.dimensions(); ++i) {
            const std::string key = i < report.study.uncertain.size()
                                        ? std::string(report.study.uncertain[i].parameter->key)
                                        : "draws";
            std::vector<std::string> cells{std::string(report.findings.aimed[o]->name), key, "", "", "", ""};
            if (!output.isConstant) {
                const SobolIndex& index = output.indices[i];
                cells[2] = numberCell(index.first.value);
                cells[3] = numberCell(index.first.error);
                cells[4] = numberCell(index.total.value);
                cells[5] = numberCell(index.total.error);
            }
            addRow(csv, cells);
        }
    }
    return csv;
}

std::string worstCsv(const DesignReport& report) {
    const DesignStudy& study = report.study;
    const std::vector<KeptParameter> parameters = study.scattered();
    std::vector<std::string> keys, titles;
    for (const KeptParameter& parameter : parameters) {
        keys.emplace_back(parameter->key);
        titles.push_back(heading(*parameter));
    }
    for (std::string& title : designHeadings(study, keys)) titles.push_back(std::move(title));
    titles.insert(titles.end(), {"aim", "sense", "value", "sampled", "searches", "agreeing"});
    std::string csv;
    addRow(csv, titles);
    for (std::size_t a = 0; a < report.findings.worst.size(); ++a) {
        const std::optional<WorstCase>& worst = report.findings.worst[a];
        if (!worst) continue;
        std::vector<std::string> cells;
        for (std::size_t i = 0; i < study.uncertain.size(); ++i) cells.push_back(numberCell(worst->at[i]));
        if (study.draws)
            for (const std::vector<double>& column : study.draws->columns)
                cells.push_back(numberCell(column[static_cast<std::size_t>(worst->at.back())]));
        for (std::string& cell : designCells(study, *report.findings.best.robust, keys))
            cells.push_back(std::move(cell));
        const bool isLargest = study.aims[a].sense == Sense::largest;
        cells.insert(cells.end(), {study.aims[a].name(), isLargest ? "min" : "max", numberCell(worst->value),
                                   numberCell(worst->sampled), std::to_string(worst->searches),
                                   std::to_string(worst->agreeing)});
        addRow(csv, cells);
    }
    return csv;
}

}  // namespace drillwave
