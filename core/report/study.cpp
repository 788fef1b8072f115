// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/study.h"

namespace drillwave {

std::optional<FigureSeries> StudyAnswer::overlay(std::size_t view, double /*until*/) const {
    const StudyFigure figure = this->figure(view);
    if (figure.panels.empty() || figure.panels.front().series.empty()) return std::nullopt;
    return figure.panels.front().series.front();
}

StudyQuestion Study::question(Scenario scenario, StudyWords words) const {
    scenario.title.clear();  // says that an example was changed
    reduce(scenario);
    return {std::move(scenario), std::move(words)};
}

const std::string* wordsOf(const StudyQuestion& question, std::string_view option) {
    const auto found = question.words.find(option);
    return found == question.words.end() ? nullptr : &found->second;
}

}  // namespace drillwave
