// SPDX-License-Identifier: GPL-3.0-or-later
// The options by which a record is read, as words: of the command line, and of the settings of a recorder.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/signal/signal_reading.h"
#include "core/text/message.h"

namespace drillwave {

struct SignalOption {
    std::string_view name;   ///< "time-unit"
    std::string_view value;  ///< what it takes, for the help; empty for a switch
    std::string_view help;   ///< one line
    /// Returns why the text cannot be taken; empty when it was.
    Message (*set)(SignalOptions& options, std::string_view text);
};

/// Returns all options, in the order of the manual.
std::span<const SignalOption> signalOptions();

/// The one of that name, or nullptr.
const SignalOption* findSignalOption(std::string_view name);

/// Returns names and values of the options that are given and belong to a recorder, not to one record: all
/// but zero, range and sign. Setting them again gives the same options.
std::vector<std::pair<std::string, std::string>> recorderSettings(const SignalOptions& options);

/// The option that answers a question of a reading: "unit" is answered by "--unit".
std::string_view answerTo(std::string_view question);

}  // namespace drillwave
