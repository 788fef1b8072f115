// SPDX-License-Identifier: GPL-3.0-or-later
// Designs of a scenario, as a design problem to be solved.
#pragma once

#include <memory>
#include <vector>

#include "core/study/design/design_problem.h"
#include "core/study/design/design_study.h"

namespace drillwave {

/// Designs of a study; its outputs are the columns of the study, then the own error of a point.
class ScenarioDesigns : public DesignProblem {
  public:
    /// The study must outlive it and have no problemsOf() it.
    explicit ScenarioDesigns(const DesignStudy& study);

    std::uint64_t designCount() const override { return m_study.designCount(); }
    std::size_t outputCount() const override { return m_columns.size(); }
    std::vector<Distribution> distributions(std::uint64_t design) const override;
    std::unique_ptr<DesignSolver> solver() const override;
    std::vector<double> likelyPlaces(std::uint64_t design, std::size_t coordinate) const override;
    /// Which points are less certain than the statistics.
    UncertainPoints uncertainPoints() const;

  private:
    const DesignStudy& m_study;
    std::vector<OutputColumn> m_columns;
};

/// The uncertain numbers as axes with their extreme values: of each input, then of each column of the draws.
std::vector<SweepAxis> uncertainAxes(const DesignStudy& study, const Scenario& design);

}  // namespace drillwave
