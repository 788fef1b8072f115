// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command.h"

#include <array>

#include "core/text/decimal_text.h"

namespace drillwave {

std::span<const Command* const> commands() {
    static const std::array all{
        &runCommand(),       &sweepCommand(),    &tableCommand(),    &curveCommand(),   &mapCommand(),
        &gapCommand(),       &thrustCommand(),   &reportCommand(),   &figuresCommand(), &accuracyCommand(),
        &stabilityCommand(), &validateCommand(), &examplesCommand(), &presetsCommand()};
    return all;
}

Arguments parseArguments(const Command& command, std::span<const std::string> words) {
    Arguments arguments = Arguments::parse(words, command.options);
    if (arguments.value("o") == std::string())
        throw CommandError(ExitCode::usage, "-o needs a name, this one is empty; - is standard output");
    const std::size_t given = arguments.operands().size();
    if (given < command.leastOperands)
        throw CommandError(ExitCode::usage, "needs " + std::string(command.operands) + "; see drillwave " +
                                                std::string(command.name) + " --help");
    if (given > command.mostOperands)
        throw CommandError(ExitCode::usage,
                           "`" + shortened(arguments.operands()[command.mostOperands]) +
                               "` is too much; takes " +
                               std::string(command.operands.empty() ? "none" : command.operands) +
                               ", see drillwave " + std::string(command.name) + " --help");
    return arguments;
}

}  // namespace drillwave
