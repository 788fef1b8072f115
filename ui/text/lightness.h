// SPDX-License-Identifier: GPL-3.0-or-later
// Light and dark grounds: which colours can be read on them.
#pragma once

#include <QColor>

class QLabel;

namespace drillwave {

/// Whether what stands on that ground is to be light.
inline bool isDark(const QColor& ground) {
    return ground.lightness() < 128;
}

// The look of a text that warns.

/// In the colour of warnings, which suits the palette, and heavy; or as it is usual. The words must say it
/// too.
void setWarning(QLabel& label, bool warning);

}  // namespace drillwave
