// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rows/output_column.h"

#include <algorithm>

#include "core/text/decimal_text.h"
#include "core/text/name_text.h"
#include "core/text/units.h"

namespace drillwave {

namespace {

constexpr std::string_view allName = "all";

Message unknownOutput(std::string_view name) {
    const std::vector<std::string_view> names = outputNames();
    std::string_view near = nearestName(name, names);
    if (near.empty()) near = nameWithWords(name, names);
    if (name == allName) return translatable("`all` are all outputs already; give nothing else");
    if (!near.empty())
        return {translatable("`%1` is not an output; did you mean `%2`?"),
                {shortened(name), std::string(near)}};
    std::string list(allName);
    for (const std::string_view known : names) list += ", " + std::string(known);
    return {translatable("`%1` is not an output; choose from %2"), {shortened(name), list}};
}

}  // namespace

std::string OutputColumn::header() const {
    return hasUnit() ? withUnit(output->name, &unitsOf(quantity()).front()) : std::string(output->name);
}

double OutputColumn::scale(const Scales& scales) const {
    if (units != OutputUnits::si) return 1;
    return output->measure == Measure::energy ? scales.energy : output->scale(scales);
}

std::optional<double> OutputColumn::value(const OutputSource& source, const Scales& scales) const {
    const std::optional<double> value = output->value(source);
    return value && units == OutputUnits::si ? output->inSi(*value, source, scales) : value;
}

OutputChoice chooseOutputs(std::string_view list, OutputUnits units) {
    OutputChoice choice;
    if (trimmed(list) == allName) {
        choice.all = true;
        for (const Output& output : outputs()) choice.columns.push_back({&output, units});
        return choice;
    }
    for (;;) {
        const std::size_t comma = list.find(',');
        const std::string_view name = trimmed(list.substr(0, comma));
        const Output* output = findOutput(name);
        if (!output) return {{}, false, unknownOutput(name)};
        if (std::ranges::find(choice.columns, output, &OutputColumn::output) != choice.columns.end())
            return {{}, false, {translatable("`%1` is given twice; give it once"), {std::string(name)}}};
        choice.columns.push_back({output, units});
        if (comma == std::string_view::npos) return choice;
        list.remove_prefix(comma + 1);
    }
}

std::vector<OutputColumn> allOutputsOf(const Scenario& scenario, OutputUnits units) {
    std::vector<OutputColumn> columns;
    for (const Output& output : outputs())
        if (output.problem(scenario).isEmpty()) columns.push_back({&output, units});
    return columns;
}

Detail detailFor(std::span<const OutputColumn> columns) {
    Detail detail = Detail::cor;
    for (const OutputColumn& column : columns) detail = std::max(detail, column.detail());
    return detail;
}

WaveNumbers waveNumbersFor(std::span<const OutputColumn> columns) {
    WaveNumbers wanted{.forcePeaks = false, .forces = {false, false, false}};
    for (const OutputColumn& column : columns) {
        const std::optional<Load> load = column.output->load;
        wanted.forces.compression |= load == Load::compression;
        wanted.forces.tension |= load == Load::tension;
        wanted.forces.after |= load && isAfter(*load);
        // what else takes the waves
        wanted.forcePeaks |= !load && column.detail() == Detail::histories;
    }
    return wanted;
}

RequiredMarches drillWishesFor(std::span<const OutputColumn> columns) {
    RequiredMarches wished;
    for (const OutputColumn& column : columns) {
        const RequiredMarches own = drillWishesOf(*column.output);
        wished.any |= own.any;
        wished.lyapunov |= own.lyapunov;
        wished.penetrationError |= own.penetrationError;
    }
    return wished;
}

Message columnProblem(std::span<const OutputColumn> columns, const Scenario& scenario) {
    const bool dimensional = hasUnits(scenario);
    for (const OutputColumn& column : columns) {
        if (column.units == OutputUnits::si && !dimensional)
            return translatable(
                "SI columns need a scenario in physical units; this one is given by its "
                "dimensionless groups");
        if (Message problem = column.output->problem(scenario); !problem.isEmpty()) return problem;
    }
    return {};
}

std::vector<std::string_view> outputNames() {
    std::vector<std::string_view> names;
    for (const std::span<const Output> table : {outputs(), drillOutputs()})
        for (const Output& output : table) names.push_back(output.name);
    return names;
}

}  // namespace drillwave
