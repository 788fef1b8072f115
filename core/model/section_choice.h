// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of sections that are worth varying, to be chosen from a list.
#pragma once

#include <vector>

#include "core/model/parameter.h"

namespace drillwave {

/// Of a string scenario every number of a section that changes results, once, in the order of a file, the
/// repeat before the sections of the string: by name ("string.coupling.diameter") where all sections of that
/// name agree in it, else by place. None of a uniform rod.
std::vector<KeptParameter> variableSectionParameters(const Scenario& scenario);

/// The diameter, or the area, of what a string is first asked for: of the sections called "coupling", else of
/// the first ones that a repeat brings, else of the first one; nullptr of a uniform rod.
KeptParameter typicalSize(const Scenario& scenario);

}  // namespace drillwave
