// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/design/design_study.h"

#include <algorithm>
#include <cassert>

#include "core/blow/blow.h"
#include "core/study/design/constant_energy.h"
#include "core/study/design/design_check.h"
#include "core/study/design/scenario_designs.h"
#include "core/study/rows/axis_scenario.h"

namespace drillwave {

namespace {

std::string at(const Output& output, const Statistic& statistic) {
    return std::string(output.name) + "@" + statistic.name();
}

void addOnce(std::vector<const Output*>& outputs, const Output* output) {
    if (std::ranges::find(outputs, output) == outputs.end()) outputs.push_back(output);
}

double energySpreadOf(const DesignStudy& study) {
    if (!hasUnits(study.base)) return 0;
    double least = blowEnergy(designScenario(study, 0)), most = least;
    for (std::uint64_t d = 1; d < study.designCount(); ++d) {
        const double energy = blowEnergy(designScenario(study, d));
        least = std::min(least, energy);
        most = std::max(most, energy);
    }
    return most / least - 1;
}

bool isOfStrength(const Alert& alert) {
    return alert.code == AlertCode::stressAboveYield || alert.code == AlertCode::stressAboveFatigue;
}

/// Whether the alert is about the numbers and not about the design.
bool isOfAccuracy(const Alert& alert) {
    using enum AlertCode;
    return alert.code == reducedAccuracy || alert.code == inputDecides || alert.code == closedFormInvalid ||
           alert.code == lengthsRounded || alert.code == stressesLeftOut;
}

std::vector<Alert> warningsOf(const Scenario& scenario, const std::stop_token& stop) {
    std::vector<Alert> warnings = solveBlow(scenario, {}, Detail::summary, stop).alerts;
    std::erase_if(warnings, [](const Alert& alert) {
        return alert.level != AlertLevel::warning || isOfAccuracy(alert);
    });
    return warnings;
}

/// Strengths first.
std::vector<Alert> alertsOf(const DesignStudy& study, std::size_t design, const std::stop_token& stop) {
    const Scenario scenario = designScenario(study, design);
    std::vector<Alert> alerts = warningsOf(scenario, stop);
    const std::vector<Alert> ofBase = scenario == study.base ? alerts : warningsOf(study.base, stop);
    std::erase_if(alerts, [&](const Alert& alert) {
        return !isOfStrength(alert) && std::ranges::any_of(ofBase, [&](const Alert& other) {
            return other.code == alert.code && other.parameter == alert.parameter;
        });
    });
    std::ranges::stable_partition(alerts, isOfStrength);
    return alerts;
}

std::optional<std::size_t> recommendedOf(const DesignStudy& study, const BestDesigns& best) {
    const std::optional<std::size_t> present = presentDesign(study);
    const bool isBest = present && std::ranges::find(best.equal, *present) != best.equal.end();
    return isBest ? present : best.chosen;
}

/// How many designs further on the next value of a choice is.
std::uint64_t strideOf(const DesignStudy& study, std::size_t choice) {
    std::uint64_t stride = 1;
    for (std::size_t i = choice + 1; i < study.choices.size(); ++i) stride *= study.choices[i].count;
    return stride;
}

/// Gives the best designs the present value of each choice that makes no difference: nobody changes a rod for
/// nothing.
void keepWhatMakesNoDifference(const DesignStudy& study, DesignFindings& found) {
    BestDesigns& best = found.best;
    const std::optional<std::size_t> present = presentDesign(study);
    if (!present || !best.robust) return;
    const auto kept = [&](std::size_t design) {
        for (std::size_t i = 0; i < study.choices.size(); ++i) {
            if (makesDifference(study, found, i)) continue;
            const std::uint64_t stride = strideOf(study, i), count = study.choices[i].count;
            design += (*present / stride % count) * stride - (design / stride % count) * stride;
        }
        return design;
    };
    if (best.chosen && std::ranges::find(best.equal, kept(*best.chosen)) != best.equal.end())
        best.chosen = kept(*best.chosen);
    const auto tie = std::ranges::find(best.ties, kept(*best.robust));
    if (tie == best.ties.end()) return;
    std::swap(*best.robust, *tie);
    std::ranges::sort(best.ties);
}

/// Designs that are tried before any samples.
constexpr std::uint64_t triedDesigns = 8;

/// Why none of some designs, evenly among all, is solved with its numbers as the scenario has them: then
/// samples about them would take long and come to nothing. Empty where one is, or on a stop.
Message unsolvedReason(const ScenarioDesigns& problem, const std::stop_token& stop) {
    const auto solver = problem.solver();
    std::vector<double> outputs(problem.outputCount());
    const std::uint64_t count = problem.designCount(), tried = std::min(count, triedDesigns);
    Message first;
    for (std::uint64_t i = 0; i < tried; ++i) {
        Message reason = solver->solveNominal(i * count / tried, outputs, stop);
        if (reason.isEmpty() || stop.stop_requested()) return {};
        if (first.isEmpty()) first = std::move(reason);
    }
    return first;
}

}  // namespace

std::string DesignAim::name() const {
    return (sense == Sense::largest ? "max:" : "min:") + at(*output, statistic);
}

std::string DesignLimit::name() const {
    return at(*output, statistic);
}

std::vector<DesignAim> customaryAims(const Scenario& scenario) {
    using Kind = Statistic::Kind;
    std::vector<DesignAim> aims{{Sense::largest, findOutput("efficiency"), {Kind::quantile, 5}}};
    if (const Output* thrust = findOutput("thrust"); thrust->problem(scenario).isEmpty())
        aims.push_back({Sense::least, thrust, {Kind::quantile, 95}});
    return aims;
}

std::uint64_t DesignStudy::designCount() const {
    std::uint64_t designs = 1;
    for (const SweepAxis& axis : choices) {
        if (axis.count > maximumSweepPoints / designs) return 0;
        designs *= axis.count;
    }
    return designs;
}

std::vector<double> DesignStudy::choice(std::uint64_t design) const {
    std::vector<double> values(choices.size());
    for (std::size_t i = choices.size(); i-- > 0; design /= choices[i].count)
        values[i] = choices[i].value(design % choices[i].count);
    return values;
}

std::vector<OutputColumn> DesignStudy::columns() const {
    std::vector<const Output*> outputs;
    for (const DesignAim& aim : aims) addOnce(outputs, aim.output);
    for (const DesignLimit& limit : limits) addOnce(outputs, limit.output);
    std::vector<OutputColumn> columns;
    for (const Output* output : outputs) {
        // Shares of the energy are compared as shares, whatever the work of the hammer.
        const bool isSi = hasUnits(base) && output->measure != Measure::energy;
        columns.push_back({output, isSi ? OutputUnits::si : OutputUnits::dimensionless});
    }
    return columns;
}

std::vector<Statistic> DesignStudy::statisticsOf(const Output& output) const {
    std::vector<Statistic> statistics(customaryStatistics().begin(), customaryStatistics().end());
    const auto add = [&](const Output* of, const Statistic& statistic) {
        if (of == &output && std::ranges::find(statistics, statistic) == statistics.end())
            statistics.push_back(statistic);
    };
    for (const DesignAim& aim : aims) add(aim.output, aim.statistic);
    for (const DesignLimit& limit : limits) add(limit.output, limit.statistic);
    return statistics;
}

std::vector<KeptParameter> DesignStudy::scattered() const {
    std::vector<KeptParameter> parameters;
    for (const UncertainInput& input : uncertain) parameters.push_back(input.parameter);
    if (draws) parameters.insert(parameters.end(), draws->parameters.begin(), draws->parameters.end());
    return parameters;
}

StatisticPlace DesignStudy::placeOf(const Output& output, const Statistic& statistic) const {
    const std::vector<OutputColumn> all = columns();
    const std::vector<Statistic> statistics = statisticsOf(output);
    const auto column = std::ranges::find(all, &output, &OutputColumn::output);
    const auto found = std::ranges::find(statistics, statistic);
    assert(column != all.end() && found != statistics.end());
    return {static_cast<std::size_t>(column - all.begin()),
            static_cast<std::size_t>(found - statistics.begin()), statistic.hasError()};
}

Scenario designScenario(const DesignStudy& study, std::uint64_t design) {
    if (study.choices.empty()) return study.base;
    Scenario scenario = AxisScenario(study.base, study.choices).set(study.choice(design));
    if (study.keepsEnergy) keepEnergy(scenario, blowEnergy(study.base));
    return scenario;
}

std::optional<std::size_t> presentDesign(const DesignStudy& study) {
    if (study.choices.empty()) return 0;
    AxisScenario scenario(study.base, study.choices);
    for (std::uint64_t d = 0; d < study.designCount(); ++d)
        if (scenario.set(study.choice(d)) == study.base) return d;
    return std::nullopt;
}

bool makesDifference(const DesignStudy& study, const DesignFindings& findings, std::size_t choice) {
    const std::uint64_t stride = strideOf(study, choice), count = study.choices[choice].count;
    for (std::size_t d = 0; d < findings.designs.size(); ++d) {
        const std::size_t first = d - (d / stride % count) * stride;
        if (findings.feasibility[d].feasible != findings.feasibility[first].feasible) return true;
        for (const DesignAim& aim : study.aims)
            if (!areTied(findings.designs[d], findings.designs[first],
                         {aim.sense, study.placeOf(*aim.output, aim.statistic)}))
                return true;
    }
    return false;
}

std::uint64_t designSolves(const DesignStudy& study) {
    return study.designCount() * study.samples + sensitivitySolves(study.dimensions(), study.samples) +
           worstSolves(study.dimensions(), study.samples);
}

DesignFindings runDesign(const DesignStudy& study, const DesignWork& work, const ShowFindings& show) {
    if (const auto problems = problemsOf(study, work.stop); !problems.empty()) {
        DesignFindings refused;
        refused.refusal = problems.front().text;
        return refused;
    }
    const ScenarioDesigns problem(study);
    DesignFindings found;
    found.unsolved = unsolvedReason(problem, work.stop);
    if (!found.unsolved.isEmpty()) return found;
    SampleOrder order{.samples = study.samples,
                      .seed = study.seed,
                      .statistics = {},
                      .uncertain = problem.uncertainPoints()};
    for (const OutputColumn& column : study.columns())
        order.statistics.push_back(study.statisticsOf(*column.output));
    order.statistics.emplace_back();  // of the own error of a point
    std::vector<AimOrder> aims;
    for (const DesignAim& aim : study.aims)
        aims.push_back({aim.sense, study.placeOf(*aim.output, aim.statistic)});
    std::vector<LimitOrder> limits;
    for (const DesignLimit& limit : study.limits)
        limits.push_back({limit.atMost, study.placeOf(*limit.output, limit.statistic), limit.bound});

    found.designs = sampleDesigns(problem, order, work);
    for (const DesignSamples& design : found.designs)
        found.feasibility.push_back(feasibilityOf(design, aims, limits));
    found.best = bestOf(found.designs, aims, limits);
    keepWhatMakesNoDifference(study, found);
    for (const DesignAim& aim : study.aims) addOnce(found.aimed, aim.output);
    found.energySpread = energySpreadOf(study);
    if (work.stop.stop_requested() || !found.best.robust) return found;
    found.recommended = recommendedOf(study, found.best);
    if (found.recommended) found.alerts = alertsOf(study, *found.recommended, work.stop);
    if (show) show(found);
    std::vector<std::size_t> aimed;
    for (const Output* output : found.aimed) aimed.push_back(study.placeOf(*output, {}).output);
    found.sensitivity = sensitivityOf(problem, *found.best.robust, aimed, study.samples, study.seed, work);
    if (show && !work.stop.stop_requested()) show(found);
    std::vector<WorstOrder> orders;
    for (const AimOrder& aim : aims)
        orders.push_back({aim.place.output, aim.sense == Sense::largest ? Sense::least : Sense::largest});
    found.worst = worstCases(problem, *found.best.robust, orders, study.samples, study.seed, work);
    return found;
}

}  // namespace drillwave
