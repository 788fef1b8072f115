// SPDX-License-Identifier: GPL-3.0-or-later
// Histories and events of one blow as CSV, with all that is needed to run the case again.
#pragma once

#include <string>
#include <string_view>

#include "core/blow/blow.h"
#include "core/blow/blow_waves.h"
#include "core/model/scales.h"
#include "core/study/rows/output_column.h"
#include "core/wave/impact.h"

namespace drillwave {

/// The program version and a scenario file as lines that begin with "#": without their leading "# " they are
/// a scenario file again, the version line, the one that names the method and the one that explains the
/// columns being comments of it (see ResultRemarks).
std::string scenarioHeader(std::string_view scenarioYaml, std::string_view method = {},
                           std::string_view columns = {});

/// Turns the lines of scenarioHeader() at the top of a CSV file back into the scenario file; empty without
/// such lines.
std::string scenarioFromHeader(std::string_view csv);

/// Writes the histories of a blow. For rods: time, impact_force, impulse, momentum, incident_wave,
/// penetration, front_velocity at the bit, from the arrival of the first wave to the end of the recording.
/// The wave is a normal force, tension positive; all else is positive towards the rock. Momentum is that of
/// the rod. Penetration is measured from the first surface of the rock, negative above it. For drill strings:
/// the same without the wave, from the first contact to the end of the blow, then face_force of hammer and
/// string, and normal_force, positive_wave and negative_wave, tension positive, and velocity at a place of
/// it; momentum is that given by the hammer to the string less the impulse on the rock. A time comes twice
/// where a curve jumps. Without SI forces are in F0, times in t0, lengths in d0, velocities in d0/t0; for
/// strings in v0. Requires Impact::hasHistories().
std::string historiesCsv(const Blow& blow, const StringPlace& place, OutputUnits units);

/// Signs and units of these columns in one line, for the header of the file, and where the place is.
std::string historyColumns(const Scenario& scenario, const StringPlace& place, OutputUnits units);

/// kind, time of every event.
std::string eventsCsv(const Impact& impact, OutputUnits units, const Scales& scales);

/// "contact", "unloading", "primary_loading", "separation".
std::string_view name(ContactEvent event);

}  // namespace drillwave
