// SPDX-License-Identifier: GPL-3.0-or-later
// Designs of a scenario, made available to the sampling routines.
#pragma once

#include <memory>
#include <vector>

#include "core/study/design/design_problem.h"
#include "core/study/design/design_study.h"

namespace drillwave {

/// Designs of a design study, solved as blows. The outputs are the columns of the study, followed by the
/// numerical error of each sample.
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
    /// Returns the settings for counting samples whose numerical error exceeds the error of the statistics.
    UncertainPoints uncertainPoints() const;

  private:
    const DesignStudy& m_study;
    std::vector<OutputColumn> m_columns;
};

/// Returns the uncertain inputs as sweep axes from their smallest to their largest value. Single inputs come
/// first, then the columns of the table of correlated values.
std::vector<SweepAxis> uncertainAxes(const DesignStudy& study, const Scenario& design);

}  // namespace drillwave
