// SPDX-License-Identifier: GPL-3.0-or-later
// Built-in examples of drill strings with losses removed from their joints; their reference values are known.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"

namespace drillwave::test {

/// Returns the text of an example without the losses of its joints. Requires an example whose joints have
/// losses.
inline std::string losslessText(std::string_view name) {
    constexpr std::string_view loss = ", loss: 5 %";
    std::string text(findExample(name)->text);
    if (text.find(loss) == std::string::npos)
        throw std::logic_error("joints of the example have no such loss");
    for (std::size_t at = text.find(loss); at != std::string::npos; at = text.find(loss, at))
        text.erase(at, loss.size());
    return text;
}

inline Scenario losslessString(std::string_view name = "t38_string") {
    return parseScenario(losslessText(name), std::string(name)).scenario;
}

}  // namespace drillwave::test
