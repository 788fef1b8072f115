// SPDX-License-Identifier: GPL-3.0-or-later
// Designs of a scenario, made available to the sampling routines.
#pragma once

#include <memory>
#include <vector>

#include "core/study/design/design_problem.h"
#include "core/study/design/design_study.h"

namespace drillwave {

/// Interface DesignProblem for a design study whose samples are solved as blows. The outputs are the columns
/// of the study, followed by the numerical error of each sample.
class ScenarioDesigns : public DesignProblem {
  public:
    /// Stores a reference to the study, which must outlive this object. Requires that problemsOf(study) is
    /// empty.
    explicit ScenarioDesigns(const DesignStudy& study);

    std::uint64_t designCount() const override { return m_study.designCount(); }
    std::size_t outputCount() const override { return m_columns.size(); }
    std::vector<Distribution> distributions(std::uint64_t design) const override;
    std::unique_ptr<DesignSolver> solver() const override;
    std::vector<double> likelyPlaces(std::uint64_t design, std::size_t coordinate) const override;
    /// Returns the settings for counting samples whose own numerical error is larger than the sampling error
    /// of the statistics.
    UncertainPoints uncertainPoints() const;

  private:
    const DesignStudy& m_study;
    std::vector<OutputColumn> m_columns;
};

/// Returns all uncertain inputs as sweep axes with their smallest and largest value. Single inputs come
/// first, then the columns of the table of correlated values.
std::vector<SweepAxis> uncertainAxes(const DesignStudy& study, const Scenario& design);

}  // namespace drillwave
