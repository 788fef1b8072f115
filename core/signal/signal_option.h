// SPDX-License-Identifier: GPL-3.0-or-later
// Options for reading a record, as words: for the command line and for the settings of a recorder.
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
    std::string_view name;   ///< name without dashes, "time-unit"
    std::string_view value;  ///< name of the value in the help, "UNIT"; empty for a switch
    std::string_view help;   ///< description in one line for the help
    /// Sets the option from text. Returns an empty message on success, otherwise what is wrong with the text.
    Message (*set)(SignalOptions& options, std::string_view text);
};

/// Returns all options for reading a record, in the order of the manual.
std::span<const SignalOption> signalOptions();

/// Returns the option with this name, such as "time-unit", or nullptr.
const SignalOption* findSignalOption(std::string_view name);

/// Returns names and values of the given options that describe the recorder, so that they can be stored for
/// other records. These are all except zero line, time range and sign. SignalOption::set restores them from
/// the texts.
std::vector<std::pair<std::string, std::string>> recorderSettings(const SignalOptions& options);

/// Returns the command-line option that answers a question in SignalReading::questions: "--unit" for "unit".
/// Empty for an unknown question.
std::string_view answerTo(std::string_view question);

}  // namespace drillwave
