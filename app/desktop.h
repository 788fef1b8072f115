// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that need the library of the desktop: the window and pictures. There are two programs with the
// same commands: `drillwave-window` is linked to it (desktop_here.cpp); `drillwave`, which starts in a
// fraction of the time, leaves them to the other one (desktop_beside.cpp).
#pragma once

#include <memory>

#include "app/drawing.h"
#include "core/text/languages.h"

namespace drillwave {

/// Opens the window, with the scenario file of the command line if it names one, and returns when it is
/// closed.
/// `--reset-ui` forgets layout, page, units and all other choices before; `--language CODE` is for this once.
/// Offers the unsaved changes of an instance that died. Throws CommandError (usage) for words that are no
/// file and no option, and where there is no display.
int openWindow(int argc, char** argv);

/// Starts drawing for a command, in a language; needs no display. Throws CommandError: usage if the program
/// that draws is missing; unwritable output if there are no fonts.
std::unique_ptr<const Drawing> startDrawing(int argc, char** argv, const Language& language);

}  // namespace drillwave
