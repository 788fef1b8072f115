// SPDX-License-Identifier: GPL-3.0-or-later
// The program without a subcommand: its window.
#pragma once

namespace drillwave {

/// Opens the window, with the scenario file of the command line if it names one, and returns when it is
/// closed. `--reset-ui` forgets layout, page, units and all other choices before. Offers the unsaved changes
/// of an instance that died. Throws CommandError (usage) for words that are no file and no option, and where
/// there is no display.
int openWindow(int argc, char** argv);

}  // namespace drillwave
