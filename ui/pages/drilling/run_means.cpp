// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/drilling/run_means.h"

namespace drillwave {

DrillingQuestion runQuestion(const Scenario& scenario) {
    DrillingQuestion question = drillingQuestion(scenario);
    question.settings.cells = scanCells;
    return question;
}

std::optional<RunMeans> runMeans(const DrillingQuestion& question, const std::stop_token& stop) {
    if (!drillingRefusals(question.scenario, question.settings).empty()) return std::nullopt;
    const DrillingResult result =
        studyDrilling(question.scenario, question.settings,
                      {.cellError = false, .lyapunov = false, .blowAlone = false}, stop);
    if (!result.statistics) return std::nullopt;
    const double penetration =
        result.spread(quantityPlace(&DrillingBlow::penetration)).mean * result.units.length();
    return RunMeans{penetration, penetration * result.frequencyUsed};
}

}  // namespace drillwave
