// Histories and events of one blow as CSV, with all that is needed to run the case again.
#pragma once

#include <string>
#include <string_view>

#include "core/model/pulse_force.h"
#include "core/model/scales.h"
#include "core/study/output_column.h"
#include "core/wave/impact.h"

namespace drillwave {

/// The program version and a scenario file as lines that begin with "#": without their leading "# " they are
/// a scenario file again, the version line and the one that names the method being comments of it.
std::string scenarioHeader(std::string_view scenarioYaml, std::string_view method = {});

/// Turns the lines of scenarioHeader() at the top of a CSV file back into the scenario file; empty without
/// such lines.
std::string scenarioFromHeader(std::string_view csv);

/// time, impact_force, impulse, momentum, incident_wave at the front end: from the arrival of the first wave
/// to the end of the recording, a time twice where a curve jumps. Momentum is that of the rod, positive
/// towards the rock. `scales` of the scenario turn the columns into SI. Requires an impact solved with
/// Detail::histories.
std::string historiesCsv(const Impact& impact, const PulseForce& pulse, OutputUnits units,
                         const Scales& scales);

/// kind, time of every event.
std::string eventsCsv(const Impact& impact, OutputUnits units, const Scales& scales);

/// "contact", "unloading", "primary_loading", "separation".
std::string_view name(ContactEvent event);

}  // namespace drillwave
