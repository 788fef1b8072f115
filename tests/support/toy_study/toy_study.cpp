// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/toy_study/toy_study.h"

#include <algorithm>

#include "core/model/parameter.h"
#include "core/report/json_value.h"
#include "core/report/report_table.h"
#include "core/study/rows/sweep_axis.h"

namespace drillwave::test {

namespace {

class ToyAnswer : public StudyAnswer {
  public:
    ToyAnswer(Scenario scenario, KeptParameter along, PeakForces found)
        : StudyAnswer(std::move(scenario)), m_along(std::move(along)), m_found(std::move(found)) {}

    Message gap() const override {
        return m_found.isStopped ? Message("was stopped before its end") : Message();
    }
    std::vector<Message> sentences(const ReadingStyle& style) const override {
        return {{"The largest force is %1.", {style.quantity(largest(), Quantity::force, 4)}}};
    }
    StudyFigure figure(std::size_t /*view*/) const override {
        StudyPanel panel;
        panel.x = {.title = Message::ofTable(m_along->label), .quantity = m_along, .target = {{m_along}}};
        panel.y = {.title = "peak force", .quantity = SiValues{Quantity::force, largest()}};
        panel.series = {{.legend = "this rod", .x = m_found.values, .y = m_found.forces.front()},
                        {.role = SeriesRole::second,
                         .legend = "other length",
                         .x = m_found.values,
                         .y = m_found.forces.back()}};
        return {.caption = {{"up to %1", {{largest(), SiValues{Quantity::force, largest()}}}}},
                .panels = {panel}};
    }
    std::optional<FigurePoint> placeOf(const Scenario& scenario, std::size_t /*view*/) const override {
        const std::optional<double> value = m_along->value(scenario);
        return value ? std::optional(FigurePoint{*value}) : std::nullopt;
    }
    std::string text(const ReadingStyle& style) const override {
        return style.said(sentences(style).front()) + "\n";
    }
    std::string json(const std::string& scenarioText) const override {
        JsonObject object = headJson({.scenario = scenario(), .scenarioText = scenarioText});
        object["largest_force"] = largest();
        return Json(object).text();
    }
    std::string csv(OutputUnits /*units*/) const override {
        return csvText(
            {.headers = {std::string(m_along->key), "peak_force", "peak_force_other"},
             .rows = m_found.values.size(),
             .cellsOf = [this](std::size_t row) {
                 return Cells{m_found.values[row], m_found.forces.front()[row], m_found.forces.back()[row]};
             }});
    }

  private:
    double largest() const { return std::ranges::max(m_found.forces.front()); }

    KeptParameter m_along;
    PeakForces m_found;
};

std::optional<StudyProblem> problem(const StudyQuestion& question) {
    const std::string* over = wordsOf(question, "over");
    if (!over) return StudyProblem{"", "needs --over KEY=START:STOP", true};
    if (const ParsedAxis axis = parseRange(*over); !axis.problem.isEmpty())
        return StudyProblem{"over", axis.problem};
    if (const std::string* length = wordsOf(question, "other-length")) {
        const TypedQuantity typed = parseQuantity(*length, Quantity::length, BareNumber::refused);
        if (!typed.valid()) return StudyProblem{"other-length", typed.problem};
        if (!(typed.si > 0)) return StudyProblem{"other-length", "must be greater than 0"};
    }
    return std::nullopt;
}

StudyAnswerPtr run(const StudyQuestion& question, const StudyWork& work) {
    const SweepAxis axis = parseRange(*wordsOf(question, "over")).axis;
    Scenario other = question.scenario;
    other.rod.length *= 2;
    if (const std::string* length = wordsOf(question, "other-length"))
        other.rod.length = parseQuantity(*length, Quantity::length, BareNumber::refused).si;
    return std::make_shared<const ToyAnswer>(
        question.scenario, axis.parameter,
        peakForces({question.scenario, other}, *axis.parameter, axis.start, axis.stop, work));
}

constexpr StudyGroup otherLength{"other", "other rod", "Length of the other rod", "", "twice as long", "of"};

double length(const Scenario& scenario) {
    return 2 * scenario.rod.length;
}

}  // namespace

const Study& toyStudy() {
    static const Study study{
        .name = "toy",
        .title = "Toy",
        .plotTitle = "Peak force over a parameter",
        .summary = "peak force over a parameter, of two rods",
        .details = "",
        .csvHelp = "also write the forces",
        .options = {{.key = "over",
                     .value = "KEY=START:STOP",
                     .help = "the parameter to go along",
                     .control = RangeControl{{"pulse.duration"}},
                     .label = "over"},
                    {.key = "other-length",
                     .value = "LENGTH",
                     .help = "length of the other rod; twice that of FILE if not given",
                     .control = QuantityControl{"rod.length", length, length},
                     .label = "length",
                     .name = "length of the other rod",
                     .group = &otherLength}},
        .views = {},
        .firstLook = "",
        .clickHelp = "A click takes the value over.",
        .hasSi = false,
        .whyNot = [](const Scenario& scenario) -> Message {
            if (hasUnits(scenario) && scenario.form == ScenarioForm::dimensional) return {};
            return "has no units";
        },
        .elsewhere = "Toy is of scenarios in physical units.",
        .reduce = [](Scenario&) {},
        .problem = problem,
        .run = run,
    };
    return study;
}

}  // namespace drillwave::test
