// SPDX-License-Identifier: GPL-3.0-or-later
// Drill strings without the strengths of their sections, which the examples have.
#pragma once

#include "core/model/scenario.h"

namespace drillwave::test {

inline Scenario withoutStrengths(Scenario scenario) {
    for (StringPart& part : scenario.drillString.parts)
        for (Section& section : part.sections) {
            section.yieldStrength.reset();
            section.fatigueStrength.reset();
        }
    return scenario;
}

}  // namespace drillwave::test
