// SPDX-License-Identifier: GPL-3.0-or-later
// Study that finds the best design of a machine or string while some inputs are uncertain.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/model/alerts.h"
#include "core/model/scenario.h"
#include "core/study/design/best_design.h"
#include "core/study/design/design_samples.h"
#include "core/study/design/draws.h"
#include "core/study/design/sensitivity.h"
#include "core/study/design/uncertain_input.h"
#include "core/study/design/worst_case.h"
#include "core/study/rows/output_column.h"
#include "core/study/rows/row_counts.h"
#include "core/study/rows/sweep_axis.h"
#include "core/wave/exact/exact_solver.h"

namespace drillwave {

inline constexpr std::size_t mostUncertain = 12, mostChoices = 4, mostAims = 3;
inline constexpr std::uint64_t mostDesigns = 10'000, mostDesignSolves = 1'000'000'000;
inline constexpr std::uint64_t leastDesignSamples = 64, mostDesignSamples = std::uint64_t{1} << 20;

/// Objective of a study: a statistic of an output that should be as large or as small as possible.
struct DesignAim {
    Sense sense = Sense::largest;
    const Output* output = nullptr;
    Statistic statistic;

    /// Returns the objective as typed on the command line, such as "max:efficiency@q05".
    std::string name() const;
    bool operator==(const DesignAim&) const = default;
};

/// Limit of a study: a statistic of an output with an upper or lower bound. The bound is in SI units if the
/// scenario has units, otherwise dimensionless.
struct DesignLimit {
    bool atMost = true;
    const Output* output = nullptr;
    Statistic statistic;
    double bound = 0;

    /// Returns output and statistic as typed on the command line, such as "thrust@q95".
    std::string name() const;
    bool operator==(const DesignLimit&) const = default;
};

/// Input of a design study. The designs are all combinations of values of the design variables (`choices`),
/// with the last variable varying fastest. Without design variables, the base scenario is the only design.
struct DesignStudy {
    Scenario base;
    std::vector<UncertainInput> uncertain;
    std::optional<Draws> draws;
    std::vector<SweepAxis> choices;
    std::vector<DesignAim> aims;
    std::vector<DesignLimit> limits;
    bool keepsEnergy = false;
    std::uint64_t samples = 4096;
    std::uint64_t seed = 1;
    long workLimit = defaultWorkLimit;

    /// Returns the number of designs: the product of the numbers of values of the design variables. 0 if it
    /// exceeds maximumSweepPoints.
    std::uint64_t designCount() const;
    /// Returns the values of the design variables of one design (index from 0), in the order of `choices`, in
    /// SI units.
    std::vector<double> choice(std::uint64_t design) const;
    /// Returns the outputs that the objectives and limits use, each once.
    std::vector<OutputColumn> columns() const;
    /// Returns the statistics computed for an output: the default ones, then those that objectives and limits
    /// use in addition.
    std::vector<Statistic> statisticsOf(const Output& output) const;
    /// Returns the number of independent uncertain inputs; a table of correlated values (`draws`) counts as
    /// one.
    std::size_t dimensions() const { return uncertain.size() + (draws ? 1 : 0); }
    /// Returns all parameters that are uncertain; those of the table of correlated values (`draws`) are last.
    std::vector<KeptParameter> scattered() const;
    /// Returns the position, in DesignSamples::statistics, of a statistic that an objective or a limit uses.
    StatisticPlace placeOf(const Output& output, const Statistic& statistic) const;
    bool operator==(const DesignStudy&) const = default;
};

/// Returns the default objectives of a design study: the largest 5 % quantile of efficiency. With a blow
/// frequency, the second is the least 95 % quantile of the required feed force.
std::vector<DesignAim> customaryAims(const Scenario& scenario);

/// Results of a design study.
struct DesignFindings {
    Message refusal = {};  ///< reason why the study cannot run; the other members are then empty
    /// Reason why no blow of the first designs tried could be solved, even with the values of the scenario;
    /// the other members are then empty.
    Message unsolved = {};
    std::vector<DesignSamples> designs;
    std::vector<Feasibility> feasibility;  ///< feasibility of each design, in the order of `designs`
    /// Best designs of the study. Design variables without influence (see makesDifference()) keep their
    /// present values in the robust and the chosen design.
    BestDesigns best;
    /// Outputs that the objectives use, each once; `sensitivity` has the same order.
    std::vector<const Output*> aimed;
    /// Sensitivity of the outputs in `aimed` to the uncertain inputs, for the design BestDesigns::robust.
    Sensitivity sensitivity;
    /// Worst case of each objective, in the order of the objectives, for the design BestDesigns::robust.
    std::vector<std::optional<WorstCase>> worst;
    /// Recommended design: the present one if it is as good as the best ones (BestDesigns::equal), otherwise
    /// BestDesigns::chosen. Empty if no design is feasible.
    std::optional<std::size_t> recommended = {};
    /// Warnings about the blow of the recommended design with the values of the scenario. They are all
    /// warnings about strength, and others that the base scenario does not have.
    std::vector<Alert> alerts = {};
    /// Ratio of the largest to the smallest blow energy of all designs, minus 1; 0 for a dimensionless
    /// scenario.
    double energySpread = 0;
};

/// Returns the valid scenario of a design (index from 0). The blow energy is the same as in the base scenario
/// if the study requires it.
Scenario designScenario(const DesignStudy& study, std::uint64_t design);

/// Returns the index of the design that equals the base scenario; empty if no design does.
std::optional<std::size_t> presentDesign(const DesignStudy& study);

/// Returns whether a design variable matters. If only its value changes, an objective must change by more
/// than its errors, or the limits become satisfied or violated.
bool makesDifference(const DesignStudy& study, const DesignFindings& findings, std::size_t choice);

/// Returns the approximate number of blows that runDesign() solves.
std::uint64_t designSolves(const DesignStudy& study);

/// Callback for intermediate results: called with the designs first, and again when the sensitivities are
/// known.
using ShowFindings = std::function<void(const DesignFindings&)>;

/// Computes a design study and returns the results. If problemsOf(study) is not empty, only `refusal` is set,
/// to the first problem. After a stop request, the result is incomplete and must not be used.
DesignFindings runDesign(const DesignStudy& study, const DesignWork& work, const ShowFindings& show = {});

}  // namespace drillwave
