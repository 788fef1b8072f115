// SPDX-License-Identifier: GPL-3.0-or-later
// An uncertain number of a scenario as it is asked for.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/model/parameter.h"
#include "core/model/scenario.h"
#include "core/study/design/distribution.h"
#include "core/text/message.h"
#include "core/text/units.h"

namespace drillwave {

/// "bit_rock.stiffness=50MN/m:250MN/m:log" or "rod.length=+-5%".
struct UncertainInput {
    KeptParameter parameter;
    DistributionKind kind = DistributionKind::uniform;
    double low = 0, high = 0;    ///< SI; of `percent` nothing
    double percent = 0;          ///< P of `percent`
    const Unit* unit = nullptr;  ///< as typed, SI where two were typed
    bool operator==(const UncertainInput&) const = default;

    /// Returns its distribution in a design, around the value of the parameter there. Requires problemIn() to
    /// be empty.
    Distribution in(const Scenario& design) const;
    /// Why it cannot scatter so in a design, as a line; empty when it can.
    Message problemIn(const Scenario& design) const;
};

/// Uncertain input read from text, or why not.
struct ParsedUncertain {
    UncertainInput input;
    bool isMistyped = false;  ///< the problem is one of the words, not of key or values
    Message problem;
};

/// Reads "KEY=LOW:HIGH[:log|normal|lognormal]" or "KEY=+-P%". Refuses unknown keys and those of no number
/// that can scatter, a range that is reversed, empty or outside that of the parameter, `log` and `lognormal`
/// from 0, and a `normal` that reaches 0 where the parameter must be more.
ParsedUncertain parseUncertain(std::string_view text);

}  // namespace drillwave
