// SPDX-License-Identifier: GPL-3.0-or-later
// The look of a text that warns.
#pragma once

class QLabel;

namespace drillwave {

/// In the colour of warnings, which suits the palette, and heavy; or as it is usual. The words must say it
/// too.
void setWarning(QLabel& label, bool warning);

}  // namespace drillwave
