// SPDX-License-Identifier: GPL-3.0-or-later
// Which choice is best over what is not known of a scenario.
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

/// Statistic that should be large, or small.
struct DesignAim {
    Sense sense = Sense::largest;
    const Output* output = nullptr;
    Statistic statistic;

    /// "max:efficiency@q05"
    std::string name() const;
    bool operator==(const DesignAim&) const = default;
};

/// A statistic that must stay on one side of a bound, SI where the scenario is.
struct DesignLimit {
    bool atMost = true;
    const Output* output = nullptr;
    Statistic statistic;
    double bound = 0;

    std::string name() const;  ///< "thrust@q95"
    bool operator==(const DesignLimit&) const = default;
};

/// Settings of a design study. Designs are the grid of the choices, the last one fastest, or only the base.
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

    std::uint64_t designCount() const;  ///< 0 if too many to count
    /// Returns the choices of a design (from 0), in their order, in SI.
    std::vector<double> choice(std::uint64_t design) const;
    /// Returns the outputs of aims and limits, each once.
    std::vector<OutputColumn> columns() const;
    /// Returns the statistics of an output: the default ones, then those needed by aims and limits.
    std::vector<Statistic> statisticsOf(const Output& output) const;
    /// Returns the number of uncertain numbers that scatter independently.
    std::size_t dimensions() const { return uncertain.size() + (draws ? 1 : 0); }
    /// Returns the parameters that scatter, those of the draws last.
    std::vector<KeptParameter> scattered() const;
    /// Returns the place in DesignSamples of the statistic of an aim or limit.
    StatisticPlace placeOf(const Output& output, const Statistic& statistic) const;
    bool operator==(const DesignStudy&) const = default;
};

/// The aims that are taken where none are given: efficiency in the worst 5 %, and thrust in the largest where
/// there is a blow frequency.
std::vector<DesignAim> customaryAims(const Scenario& scenario);

/// Results of a design study.
struct DesignFindings {
    Message refusal = {};   ///< why the study cannot be made; then all else is empty
    Message unsolved = {};  ///< why no design is solved even without scatter; then all else is empty
    std::vector<DesignSamples> designs;
    std::vector<Feasibility> feasibility;  ///< of each
    BestDesigns best;  ///< the robust and the chosen one with the present value of what makesDifference() not
    std::vector<const Output*> aimed;             ///< outputs of the aims, each once: those of
    Sensitivity sensitivity;                      ///< at the robust best
    std::vector<std::optional<WorstCase>> worst;  ///< of each aim, at the robust best
    /// Recommended design: the base if it is equal to the best ones, else that of the aims.
    std::optional<std::size_t> recommended = {};
    /// Warnings of the blow of that design with the values entered: all about strengths, and those that the
    /// base does not have.
    std::vector<Alert> alerts = {};
    double energySpread = 0;  ///< largest over least energy of the designs, less 1; 0 without units
};

/// A scenario for every design, valid, with its energy kept.
Scenario designScenario(const DesignStudy& study, std::uint64_t design);

/// The number of the design that is the base itself; nothing where it is none of the choices.
std::optional<std::size_t> presentDesign(const DesignStudy& study);

/// Whether designs that differ only in that choice differ in any aim by more than the errors, or in meeting
/// the limits.
bool makesDifference(const DesignStudy& study, const DesignFindings& findings, std::size_t choice);

/// About how many blows runDesign() solves.
std::uint64_t designSolves(const DesignStudy& study);

/// Called with the results so far: the designs, then with indices.
using ShowFindings = std::function<void(const DesignFindings&)>;

/// Returns only the first line of problemsOf() the study if there are any. After a stop, the result must not
/// be used.
DesignFindings runDesign(const DesignStudy& study, const DesignWork& work, const ShowFindings& show = {});

}  // namespace drillwave
