// SPDX-License-Identifier: GPL-3.0-or-later
// The one table of outputs (files §4): JSON, columns, --outputs, the help and the window's results come from
// it.
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

/// Reference quantity of an output, which decides how it is shown.
enum class Measure {
    number,       ///< a plain number
    error,        ///< a number of which only the size matters
    work,         ///< W0: a plain number in SI, too
    share,        ///< W, the work of the hammer: a plain number in SI, too
    energy,       ///< such a share; in SI [J]
    time,         ///< t0
    impulse,      ///< I0
    force,        ///< F0
    penetration,  ///< d0
    stress,       ///< F0/A
    velocity,     ///< v0
    newton,       ///< [N]: neither this nor those below have a dimensionless number
    watt,         ///< [W]
    speed,        ///< [m/s]
};

/// Heading under which the window lists an output.
enum class OutputGroup { none, work, share, penetration, rebound, stress, contact };

/// Blows for which an output is defined, whether its value is known or not.
enum class OutputOf { anyBlow, uniformRod, drillString, hammer, elasticFaces };
bool concerns(OutputOf which, const Scenario& scenario);

/// Destinations of the work of the hammer, in the order of a bar; of the energy of a followed hammer.
enum class EnergyPart {
    rock,
    rebound,
    waves,   ///< left in the rod or the string
    hammer,  ///< of a drill string: still in the hammer, moving and in waves
    losses,  ///< of a drill string: in joints, on the way, and between the faces
};

/// Sources of outputs: parts of a Blow.
struct OutputSource {
    const ImpactSummary& summary;
    const Scenario& scenario;
    std::optional<double> thrustMargin = {};  ///< of the study of all gaps, where one was made
    const DrillNumbers* drill = nullptr;      ///< of many blows, where they were marched
};

/// Named output: JSON key, CSV column, name for --outputs, and row of the window.
struct Output {
    std::string_view name;     ///< "peak_force"
    std::string_view meaning;  ///< one line
    Measure measure;
    Detail detail;  ///< required from the solver
    /// Returns the value in units of `measure`; nullopt without the waves or where problem() says why.
    std::optional<double> (*number)(const OutputSource&);
    std::string_view title;  ///< in reports: "peak force"
    OutputOf of = OutputOf::anyBlow;
    OutputGroup group = OutputGroup::none;
    std::string_view note = {};           ///< in the window, a description without its full stop
    std::optional<EnergyPart> part = {};  ///< the part that it belongs to, or is
    std::optional<Load> load = {};        ///< which one, where it is a largest force in the rod
    /// Returns why a scenario for which the output is defined has no value; nullptr if every one has a value.
    Message (*lack)(const Scenario&) = nullptr;
    std::string_view shortTitle = {};  ///< in the window, where it is another one
    int order = 0;                     ///< in its group: lasting values before momentary maxima

    /// Returns why such a scenario has no value and what to do; empty if it has one.
    Message problem(const Scenario& scenario) const;
    /// Returns the value in `measure`; nothing without the waves, or where problem() says why.
    std::optional<double> value(const OutputSource& source) const {
        return concerns(source.scenario) ? number(source) : std::nullopt;
    }
    /// Returns whether it is defined for such scenarios, whether its value is known or not: a uniform rod has
    /// no energy lost in joints.
    bool concerns(const Scenario& scenario) const;
    std::string_view label() const;  ///< in the window: "peak force"; empty where it lists none
    bool isOnlySi() const;           ///< there is no dimensionless number
    bool needsThrustStudy() const;   ///< whether OutputSource::thrustMargin must be there
    bool needsDrilling() const;      ///< whether OutputSource::drill must be set: for drillOutputs()
    /// Returns `ratio` if SI is the same number, and for a share of the energy.
    Quantity quantity() const;
    /// The quantity of inSi(): energy for a share of the energy, else quantity().
    Quantity siQuantity() const;
    /// SI = value · scale; a share of the energy stays a share.
    double scale(const Scales& scales) const;
    /// Converts a value to SI; energy shares become J and need the hammer work in `source`.
    double inSi(double value, const OutputSource& source, const Scales& scales) const;
};

/// Returns all outputs of one blow, in the order of files §4.
std::span<const Output> outputs();

/// Returns the outputs of many blows under a feed, `drill_…`: the rows of the table after those of one blow.
/// Each case takes a march, so they are computed only when requested by name.
std::span<const Output> drillOutputs();

/// Returns what an output of drillOutputs() requires to be computed.
RequiredMarches drillWishesOf(const Output& output);

/// Returns why a blow that was solved with `detail` is no result: "max_penetration is beyond the range of …"
/// if an output, or its number in SI, is infinite or NaN. Empty otherwise; times of what never happens may be
/// NaN.
Message overflowProblem(const OutputSource& source, const Scales& scales, Detail detail);
/// Returns the same for a single value of an output.
Message overflowProblem(const Output& output, double value);

/// Main output of a blow and its error: the efficiency where cells estimate its error, else e.
struct MainOutput {
    const Output *value, *error;
};
MainOutput mainOutput(const Scenario& scenario);

/// Returns the output of that name, of one blow or of many; nullptr if there is none.
const Output* findOutput(std::string_view name);

}  // namespace drillwave
