// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/design/scenario_designs.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/model/parameter.h"
#include "core/model/scales.h"
#include "core/study/rows/axis_scenario.h"
#include "core/study/rows/case_solver.h"
#include "core/text/message.h"

namespace drillwave {

namespace {

SweepAxis axisOf(const KeptParameter& parameter, double low, double high) {
    SweepAxis axis;
    axis.parameter = parameter;
    axis.unit = &parameter->displayUnit();
    axis.kind = SweepAxis::Kind::list;
    axis.list = {low, high};
    axis.count = 2;
    return axis;
}

class ScenarioSolver : public DesignSolver {
  public:
    ScenarioSolver(const DesignStudy& study, std::span<const OutputColumn> columns)
        : m_study(study), m_solver(columns, {}, study.workLimit) {}

    Message solve(std::uint64_t design, std::span<const double> values, std::span<double> outputs,
                  const std::stop_token& stop) override {
        moveTo(design);
        const std::size_t inputs = m_study.uncertain.size();
        std::ranges::copy(values.first(inputs), m_values.begin());
        if (m_study.draws) {
            const auto row = static_cast<std::size_t>(values[inputs]);
            for (std::size_t i = 0; i < m_study.draws->columns.size(); ++i)
                m_values[inputs + i] = m_study.draws->columns[i][row];
        }
        m_scene->set(m_values);
        if (m_scene->obstacle()) return m_scene->obstacle()->reason;
        if (!m_hasPulse || m_scene->movesPulse(0)) m_solver.setPulse(m_scene->scenario());
        m_hasPulse = !m_scene->movesPulse(0);
        return checked(m_solver.solve(m_scene->scenario(), outputs, stop), outputs);
    }

    Message solveNominal(std::uint64_t design, std::span<double> outputs,
                         const std::stop_token& stop) override {
        moveTo(design);
        m_solver.setPulse(*m_scenario);
        m_hasPulse = false;
        return checked(m_solver.solve(*m_scenario, outputs, stop), outputs);
    }

  private:
    void moveTo(std::uint64_t design) {
        if (m_scenario && m_design == design) return;
        m_design = design;
        m_scene.reset();
        m_scenario = designScenario(m_study, design);
        m_axes = uncertainAxes(m_study, *m_scenario);
        m_scene.emplace(*m_scenario, m_axes);
        m_values.resize(m_axes.size());
        m_hasPulse = false;
    }

    /// A blow without a number that is asked for counts as not solved.
    static Message checked(Message reason, std::span<const double> outputs) {
        if (!reason.isEmpty()) return reason;
        return std::ranges::any_of(outputs, [](double value) { return std::isnan(value); })
                   ? Message(translatable("some output has no value"))
                   : Message();
    }

    const DesignStudy& m_study;
    CaseSolver m_solver;
    std::uint64_t m_design = 0;
    std::optional<Scenario> m_scenario;
    std::vector<SweepAxis> m_axes;
    std::optional<AxisScenario> m_scene;
    std::vector<double> m_values;
    bool m_hasPulse = false;
};

}  // namespace

ScenarioDesigns::ScenarioDesigns(const DesignStudy& study) : m_study(study), m_columns(study.columns()) {
    m_columns.push_back({mainOutput(study.base).error});
}

std::vector<Distribution> ScenarioDesigns::distributions(std::uint64_t design) const {
    const Scenario scenario = designScenario(m_study, design);
    std::vector<Distribution> distributions;
    for (const UncertainInput& input : m_study.uncertain) distributions.push_back(input.in(scenario));
    if (m_study.draws) distributions.push_back(Distribution::ofRows(m_study.draws->rows()));
    return distributions;
}

std::unique_ptr<DesignSolver> ScenarioDesigns::solver() const {
    return std::make_unique<ScenarioSolver>(m_study, m_columns);
}

std::vector<double> ScenarioDesigns::likelyPlaces(std::uint64_t design, std::size_t coordinate) const {
    constexpr std::size_t most = 64;
    if (coordinate >= m_study.uncertain.size()) return {};
    const UncertainInput& input = m_study.uncertain[coordinate];
    const bool isGroup = input.parameter->key == "delta";
    if (!isGroup && input.parameter->key != "bit_rock.gap") return {};
    const Scenario scenario = designScenario(m_study, design);
    const double step = isGroup ? 1 : scalesOf(scenario).penetration;
    const Distribution gaps = input.in(scenario);
    std::vector<double> places;
    for (double number = std::max(0.0, std::ceil(gaps.low() / step));
         number * step <= gaps.high() && places.size() < most; ++number)
        if (number * step > gaps.low() && number * step < gaps.high()) places.push_back(number * step);
    return places;
}

UncertainPoints ScenarioDesigns::uncertainPoints() const {
    UncertainPoints points{.errorOutput = m_columns.size() - 1, .isRelative = {}};
    for (const OutputColumn& column : m_columns)
        points.isRelative.push_back(column.output->measure != Measure::number &&
                                    column.output->measure != Measure::share);
    return points;
}

std::vector<SweepAxis> uncertainAxes(const DesignStudy& study, const Scenario& design) {
    std::vector<SweepAxis> axes;
    for (const UncertainInput& input : study.uncertain) {
        const Distribution distribution = input.in(design);
        axes.push_back(axisOf(input.parameter, distribution.least(), distribution.most()));
    }
    if (study.draws)
        for (std::size_t i = 0; i < study.draws->parameters.size(); ++i) {
            const auto [low, high] = std::ranges::minmax_element(study.draws->columns[i]);
            axes.push_back(axisOf(study.draws->parameters[i], *low, *high));
        }
    return axes;
}

}  // namespace drillwave
