// SPDX-License-Identifier: GPL-3.0-or-later
// Light and dark grounds: which colours can be read on them.
#pragma once

#include <QColor>

class QLabel;

namespace drillwave {

/// Whether words on that ground should be light.
inline bool isDark(const QColor& ground) {
    return ground.lightness() < 128;
}

// The look of a text that warns.

/// Shows a label in the colour of warnings, which suits the palette, and bold; or as usual. The words must
/// express it as well.
void setWarning(QLabel& label, bool warning);

}  // namespace drillwave
