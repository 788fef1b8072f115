// SPDX-License-Identifier: GPL-3.0-or-later
// What of a scenario is one word out of a list: the shape of the blow, the law of the rock.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "core/model/scenario.h"
#include "core/text/message.h"

namespace drillwave {

struct WordParameter {
    std::string_view key;                          ///< "pulse.shape"
    std::span<const std::string_view> (*words)();  ///< all there are
    std::string_view (*value)(const Scenario&);    ///< the one of a scenario
    /// Sets the word of that number. Returns why the scenario has none of this key, or not that one: "only a
    /// drill string has it …"; empty when done.
    Message (*assign)(Scenario&, std::size_t word);

    /// "rectangular, triangular, …", for messages.
    std::string list() const;
};

std::span<const WordParameter> wordParameters();
/// Or nullptr.
const WordParameter* findWordParameter(std::string_view key);

}  // namespace drillwave
