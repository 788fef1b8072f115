// SPDX-License-Identifier: GPL-3.0-or-later
// Table of all outputs (files §4). JSON, CSV columns, --outputs, the help and the window's results are made
// from it.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/blow/drill_problems.h"
#include "core/blow/impact_summary.h"
#include "core/model/scales.h"
#include "core/model/scenario.h"
#include "core/text/message.h"
#include "core/text/units.h"
#include "core/wave/impact.h"

namespace drillwave {

/// Unit of an output, which decides how it is shown and converted to SI.
enum class Measure {
    /// Plain number, without a unit.
    number,
    /// Error; a number of which only the order of magnitude matters.
    error,
    /// Energy as a share of W0 = m v0²/2. In SI it remains this share.
    work,
    /// Share of the hammer work W. In SI it remains this share.
    share,
    /// Share of the hammer work W; in SI an energy in J.
    energy,
    /// Time, in units of t0, the duration of the hammer force.
    time,
    /// Impulse, in units of I0, the impulse of the hammer force.
    impulse,
    /// Force, in units of F0 = I0/t0, the mean hammer force.
    force,
    /// Length, in units of d0 = 2 I0/Z, which is the advance of a free rod in one round trip of a wave.
    penetration,
    /// Stress, in units of F0/A: mean hammer force over cross-section of the rod.
    stress,
    /// Velocity, in units of v0: velocity of the hammer, or I0 over the mass of the rod.
    velocity,
    /// Force in N; there is no dimensionless number.
    newton,
    /// Power in W; there is no dimensionless number.
    watt,
    /// Velocity in m/s; there is no dimensionless number.
    speed,
};

/// Heading under which the window lists an output; `none` if it does not list it.
enum class OutputGroup { none, work, share, penetration, rebound, stress, contact };

/// Kind of blow for which an output is defined, whether or not its value is known.
enum class OutputOf { anyBlow, uniformRod, drillString, hammer, elasticFaces };
/// Returns whether the scenario describes a blow of the kind `which`, such as one on a drill string.
bool concerns(OutputOf which, const Scenario& scenario);

/// Parts of the hammer work after a blow, or of the hammer energy of a drill string, in the order of a bar
/// chart.
enum class EnergyPart {
    /// Work that stays in the rock.
    rock,
    /// Energy of the rebound of rod or string as a whole, as a part of the hammer work.
    rebound,
    /// Energy of the waves that remain in rod or string, as a part of the hammer work.
    waves,
    /// Energy that remains in the hammer of a drill string, as motion and as waves.
    hammer,
    /// Energy lost in joints and sections of a drill string, or left in the elastic contact between hammer
    /// and string.
    losses,
};

/// Parts of a Blow from which the values of outputs are computed.
struct OutputSource {
    /// Results of the blow, dimensionless.
    const ImpactSummary& summary;
    /// Scenario of the blow.
    const Scenario& scenario;
    /// Margin of the feed force, from a study of all gaps; nothing if there was no such study.
    std::optional<double> thrustMargin = {};
    /// Statistics of many blows; null if no sequence of blows was computed.
    const DrillNumbers* drill = nullptr;
};

/// Output with its name, which is a JSON key, a CSV column, an argument of --outputs and a row of the window.
struct Output {
    /// Name of the output, such as "peak_force".
    std::string_view name;
    /// Meaning of the output in one line.
    std::string_view meaning;
    /// Unit, which decides how the value is shown.
    Measure measure;
    /// Least detail with which the solver must be called for this output.
    Detail detail;
    /// Function that returns the value in units of `measure`; nullopt if it needs waves that were not
    /// computed, or if problem() gives a reason.
    std::optional<double> (*number)(const OutputSource&);
    /// Title in reports, such as "peak force".
    std::string_view title;
    /// Kind of blow for which the output is defined, such as drill strings only.
    OutputOf of = OutputOf::anyBlow;
    /// Heading under which the window lists the output.
    OutputGroup group = OutputGroup::none;
    /// Description in the window, without a full stop.
    std::string_view note = {};
    /// Part of the hammer work that this output states, or to which it belongs; empty for other outputs.
    std::optional<EnergyPart> part = {};
    /// Kind of load (compression or tension, during or after the blow) if the output is a largest force or
    /// stress; otherwise empty.
    std::optional<Load> load = {};
    /// Function that returns the reason why the output has no value for a scenario, although it is defined
    /// for this kind of blow. It is nullptr if the output always has a value.
    Message (*lack)(const Scenario&) = nullptr;
    /// Title in the window if it differs from `title`; otherwise empty.
    std::string_view shortTitle = {};
    /// Sorting key of the output within its group in the window, ascending. Final values have lower keys than
    /// largest values during the blow.
    int order = 0;

    /// Returns the reason why a scenario, for which the output is defined, has no value, and the remedy;
    /// empty if it has a value.
    Message problem(const Scenario& scenario) const;
    /// Returns the value in units of `measure`; nothing if it needs waves that were not computed, or if
    /// problem() gives a reason.
    std::optional<double> value(const OutputSource& source) const {
        return concerns(source.scenario) ? number(source) : std::nullopt;
    }
    /// Returns whether the output is defined for the scenario, whether or not its value is known. For
    /// example, a uniform rod has no energy lost in joints.
    bool concerns(const Scenario& scenario) const;
    /// Returns the title in the window, such as "peak force"; empty if the window does not list the output.
    std::string_view label() const;
    /// Returns whether the output has a value in SI units only, and no dimensionless one.
    bool isOnlySi() const;
    /// Returns whether the value requires a study over all gaps between bit and rock, which supplies
    /// OutputSource::thrustMargin.
    bool needsThrustStudy() const;
    /// Returns whether the output requires OutputSource::drill; true for all drillOutputs().
    bool needsDrilling() const;
    /// Returns the physical quantity of the value; Quantity::ratio for shares of the energy, and for numbers
    /// that are the same in SI.
    Quantity quantity() const;
    /// Returns the physical quantity of the value after conversion by inSi(). It is an energy for an energy
    /// share that inSi() converts to J, otherwise the same as quantity().
    Quantity siQuantity() const;
    /// Returns the factor by which the dimensionless value is multiplied to give SI units; 1 for a share of
    /// the energy.
    double scale(const Scales& scales) const;
    /// Returns the value converted to SI. A share of the energy becomes J, with the hammer work in `source`.
    double inSi(double value, const OutputSource& source, const Scales& scales) const;
};

/// Returns all outputs of one blow, in the order of files §4.
std::span<const Output> outputs();

/// Returns the outputs `drill_…` of many blows under a feed, which follow those of one blow in the table.
/// They require a sequence of blows for each case, so they are computed only when requested by name.
std::span<const Output> drillOutputs();

/// Returns which sequences of blows must be computed for an output of drillOutputs().
RequiredMarches drillWishesOf(const Output& output);

/// Returns the reason why a blow solved with `detail` has no valid result: "max_penetration is beyond the
/// range of …" if an output, or its value in SI, is infinite or NaN. Returns an empty message otherwise.
/// Times of events that never happen may be NaN.
Message overflowProblem(const OutputSource& source, const Scales& scales, Detail detail);
/// Returns the reason why a value of an output is invalid because it is infinite or NaN; empty if it is
/// valid. The time of an event that never happens may be NaN.
Message overflowProblem(const Output& output, double value);

/// Main output of a blow and its error: the efficiency if its error is estimated (drill strings), otherwise
/// the coefficient of restitution.
struct MainOutput {
    const Output *value, *error;
};
/// Returns the main output of a blow of this scenario, and the output that is its error.
MainOutput mainOutput(const Scenario& scenario);

/// Returns the output with the given name, of one blow or of many; nullptr if there is none.
const Output* findOutput(std::string_view name);

}  // namespace drillwave
