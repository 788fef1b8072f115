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
    /// Error, or bound of an error, without a unit. Only its order of magnitude matters, so few digits are
    /// shown.
    error,
    /// Energy as a share of W0 = m v0²/2, with the mass m of rod or hammer. With SI units, the output still
    /// shows this share.
    work,
    /// Share of the hammer work W. With SI units, the output still shows this share.
    share,
    /// Energy as a share of the hammer work W. With SI units, the output shows the energy in J.
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
    /// Force in N, of an output that has no dimensionless value.
    newton,
    /// Power in W, of an output that has no dimensionless value.
    watt,
    /// Velocity in m/s, of an output that has no dimensionless value.
    speed,
};

/// Heading under which the window lists an output; `none` if it does not list it.
enum class OutputGroup { none, work, share, penetration, rebound, stress, contact };

/// Kind of blow for which an output is defined. The value of a defined output may still be unknown.
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
    /// Margin of the feed force: (effective feed force)/(largest required feed force) − 1. It needs a study
    /// of all gaps between bit and rock; nullopt if there was no such study.
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
    /// Least Detail with which a blow must be solved to get this output.
    Detail detail;
    /// Function that returns the value of the output, in units of `measure`. It returns nullopt if the value
    /// needs waves that were not computed, or if problem() gives a reason.
    std::optional<double> (*number)(const OutputSource&);
    /// Title in reports, such as "peak force".
    std::string_view title;
    /// Kind of blow for which the output is defined, for example only blows on a drill string.
    OutputOf of = OutputOf::anyBlow;
    /// Heading under which the window lists the output.
    OutputGroup group = OutputGroup::none;
    /// Description of the output in the window, without a full stop.
    std::string_view note = {};
    /// Part of the energy balance that the output describes, for example EnergyPart::losses for the energy
    /// lost in joints. Nullopt for outputs that are not a part of the balance.
    std::optional<EnergyPart> part = {};
    /// Kind of load (compression or tension, during or after the blow) if the output is a largest force or
    /// stress; otherwise empty.
    std::optional<Load> load = {};
    /// Function that returns the reason why the output has no value for a scenario, although it is defined
    /// for this kind of blow. It is nullptr if the output always has a value.
    Message (*lack)(const Scenario&) = nullptr;
    /// Title in the window if it differs from `title`; otherwise empty.
    std::string_view shortTitle = {};
    /// Position of the output within its group in the window: outputs with a lower number come first. Final
    /// values have lower numbers than largest values during the blow.
    int order = 0;

    /// Returns the reason why the output has no value for a scenario, and the remedy; empty if it has a
    /// value. The output may be undefined for this kind of blow, or an input may be missing.
    Message problem(const Scenario& scenario) const;
    /// Returns the value of the output for a blow, in units of `measure`. Returns nullopt if it needs waves
    /// that were not computed, or if problem() gives a reason.
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
    /// Returns whether the value requires a study of all gaps between bit and rock. Then the caller has to
    /// set OutputSource::thrustMargin from this study.
    bool needsThrustStudy() const;
    /// Returns whether the output is a statistic of a sequence of blows (OutputSource::drill), as all
    /// drillOutputs() are.
    bool needsDrilling() const;
    /// Returns the physical quantity of the value; Quantity::ratio for shares of the energy, and for numbers
    /// that are the same in SI.
    Quantity quantity() const;
    /// Returns the physical quantity of the value after conversion by inSi(). It is an energy for an energy
    /// share that inSi() converts to J, otherwise the same as quantity().
    Quantity siQuantity() const;
    /// Returns the factor from the dimensionless value of the output to SI units; 1 for a share of the
    /// energy.
    double scale(const Scales& scales) const;
    /// Returns the value converted to SI. A share of the energy becomes J, with the hammer work in `source`.
    double inSi(double value, const OutputSource& source, const Scales& scales) const;
};

/// Returns all outputs of one blow, in the order of files §4.
std::span<const Output> outputs();

/// Returns the outputs `drill_…` of many blows under a feed, which follow those of one blow in the table.
/// They require a sequence of blows for each case, so they are computed only when requested by name.
std::span<const Output> drillOutputs();

/// Returns which sequences of blows have to be computed to get the value of `output`, one of drillOutputs().
RequiredMarches drillWishesOf(const Output& output);

/// Returns the reason why the result of a blow solved with `detail` is invalid, such as "max_penetration is
/// beyond the range of …". It is invalid if an output, or its value in SI, is infinite or NaN. Times of
/// events that never happen may be NaN. Returns an empty message if the result is valid.
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
