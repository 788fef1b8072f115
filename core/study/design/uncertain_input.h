// SPDX-License-Identifier: GPL-3.0-or-later
// Uncertain input of a scenario, as requested by the user.
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

/// Uncertain input as typed on the command line, such as "bit_rock.stiffness=50MN/m:250MN/m:log" or
/// "rod.length=+-5%".
struct UncertainInput {
    KeptParameter parameter;
    DistributionKind kind = DistributionKind::uniform;
    double low = 0, high = 0;  ///< limits LOW and HIGH of the range, in SI units; not used for `percent`
    double percent = 0;        ///< half-width P of a `percent` range, in per cent of the value of the design
    /// Unit typed for the range; the SI unit if LOW and HIGH had different units.
    const Unit* unit = nullptr;
    bool operator==(const UncertainInput&) const = default;

    /// Returns the distribution of the input for a design. A `percent` range is centred on the parameter's
    /// value in this design. Requires that problemIn() is empty.
    Distribution in(const Scenario& design) const;
    /// Returns the reason why the input cannot vary over its range in a design; empty if it can.
    Message problemIn(const Scenario& design) const;
};

/// Uncertain input read from text, or the reason why it could not be read.
struct ParsedUncertain {
    UncertainInput input;
    /// Whether the problem is a misspelt word rather than an invalid key or value.
    bool isMistyped = false;
    Message problem;
};

/// Returns the uncertain input read from "KEY=LOW:HIGH[:log|normal|lognormal]" or "KEY=+-P%", or the problem
/// of this text. Refuses unknown keys, keys without a numerical value, and ranges that are reversed, empty or
/// outside the allowed range. Also refuses `log` and `lognormal` from 0, and a `normal` that reaches 0 if the
/// parameter must be positive.
ParsedUncertain parseUncertain(std::string_view text);

}  // namespace drillwave
