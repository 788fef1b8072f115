// SPDX-License-Identifier: GPL-3.0-or-later
// Histories and events of one blow as CSV, with everything needed to run the case again.
#pragma once

#include <string>
#include <string_view>

#include "core/blow/blow.h"
#include "core/blow/blow_waves.h"
#include "core/model/scales.h"
#include "core/study/rows/output_column.h"
#include "core/wave/impact.h"

namespace drillwave {

/// Returns comment lines for the top of a CSV file, each with the prefix "# ". They contain program version,
/// method, meaning of the columns, and the scenario file. Without the prefix, they are a valid scenario file
/// that begins with up to three comment lines (see ResultRemarks).
std::string scenarioHeader(std::string_view scenarioYaml, std::string_view method = {},
                           std::string_view columns = {});

/// Returns the scenario file from the lines of scenarioHeader() at the top of a CSV file; empty if there are
/// none.
std::string scenarioFromHeader(std::string_view csv);

/// Returns the histories of a blow as CSV. Requires Impact::hasHistories(). Values are positive towards the
/// rock; normal forces and waves are positive in tension.
/// For a uniform rod the columns are time, impact_force, impulse, momentum, incident_wave, penetration and
/// front_velocity at the bit. The histories run from the arrival of the first wave to the end of the
/// recording. Momentum is that of the rod. Penetration is measured from the original surface of the rock,
/// negative above it.
/// For a drill string the histories run from the first contact to the end of the blow, without the incident
/// wave. Further columns are the face_force between hammer and string, and normal_force, positive_wave,
/// negative_wave and velocity at `place`. Momentum is that transferred by the hammer to the string, minus the
/// impulse on the rock.
/// A time occurs twice where a curve jumps. Dimensionless forces are in F0, times in t0, lengths in d0,
/// velocities in d0/t0; for strings velocities are in v0.
std::string historiesCsv(const Blow& blow, const StringPlace& place, OutputUnits units);

/// Returns one line on the columns of historiesCsv(), for the comment lines at the top of the file. It states
/// their signs and units. For a drill string, it also states the position `place` of the waves.
std::string historyColumns(const Scenario& scenario, const StringPlace& place, OutputUnits units);

/// Returns the events at the bit, such as contact and separation, as CSV with the columns kind and time.
std::string eventsCsv(const Impact& impact, OutputUnits units, const Scales& scales);

/// Returns the name of an event at the bit: "contact", "unloading", "primary_loading", "separation" or
/// "corner".
std::string_view name(ContactEvent event);

}  // namespace drillwave
