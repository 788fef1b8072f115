// SPDX-License-Identifier: GPL-3.0-or-later
// The program without the library of the desktop: it executes the one that has it.
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "app/command_error.h"
#include "app/desktop.h"
#include "app/interruption.h"
#include "app/window_arguments.h"

namespace drillwave {

namespace {

/// Does not come back where there is a program that can go on, in the folder of this one.
void goOnBeside(char** argv) {
    std::error_code error;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
    if (!error) ::execv((self.parent_path() / "drillwave-window").c_str(), argv);
}

constexpr const char* noWindowProgram = translatable(
    "there is no drillwave-window beside this program; install the package drillwave, or build the "
    "program with DRILLWAVE_GUI=ON");

}  // namespace

int openWindow(int argc, char** argv) {
    goOnBeside(argv);
    // Mistyped commands are worth more than the missing window.
    windowArguments(std::vector<std::string>(argv + 1, argv + argc));
    throw CommandError(
        ExitCode::usage,
        Message(translatable("no window: %1; without it use `drillwave run FILE` (see --help)"),
                {noWindowProgram}));
}

std::unique_ptr<const Drawing> startDrawing(int, char** argv, const Language&) {
    // Until that program is loaded nothing in it could answer a signal.
    holdInterruptions();
    goOnBeside(argv);
    exitOnInterruption();
    throw CommandError(
        ExitCode::usage,
        Message(translatable("no pictures: %1; without it leave out --plots, and write a report with "
                             "--no-plots"),
                {noWindowProgram}));
}

}  // namespace drillwave
