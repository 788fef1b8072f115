// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that need the Qt desktop library: the window and pictures. Two programs have the same commands.
// `drillwave-window` is linked to the library (desktop_here.cpp). `drillwave` is not, so it starts in a
// fraction of the time; it runs the other program when the library is needed (desktop_beside.cpp).
#pragma once

#include <memory>

#include "app/drawing.h"
#include "core/text/languages.h"

namespace drillwave {

/// Opens the window, with the scenario file of the command line if one is given, and returns the exit code
/// when it is closed. `--reset-ui` first deletes the stored layout, page, units and other choices.
/// `--language CODE` applies only to this run. Offers to restore unsaved changes of an instance that crashed.
/// Throws CommandError (usage) for words that are neither file nor option, and without a display.
int openWindow(int argc, char** argv);

/// Returns an object that draws pictures with words in `language`; needs no display. Throws CommandError:
/// usage if the program that draws is missing; unwritable output if no fonts are installed.
std::unique_ptr<const Drawing> startDrawing(int argc, char** argv, const Language& language);

}  // namespace drillwave
