// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/axis_argument.h"

#include "app/command_error.h"
#include "app/scenario_argument.h"
#include "core/text/decimal_text.h"

namespace drillwave {

SweepAxis axisArgument(const Arguments& arguments, const std::string& option, const std::string& word) {
    ParsedAxis parsed = parseAxis(word);
    if (!parsed.problem.empty()) {
        // A value that the parameter cannot take is like one in a file; anything else is a mistyped command.
        const bool badValue = parsed.kind == ParsedAxis::Kind::badValue;
        throw CommandError(badValue ? ExitCode::invalidScenario : ExitCode::usage,
                           "--" + option + ": " + parsed.problem);
    }
    checkNotSet(arguments, parsed.axis.key(), "--" + option + " " + shortened(word));
    return std::move(parsed.axis);
}

RecordedAxis recordedAxis(const SweepAxis& axis, const std::string& word) {
    return {axis.column().header, word.substr(word.find('=') + 1), axis.count};
}

}  // namespace drillwave
