// SPDX-License-Identifier: GPL-3.0-or-later
// Light and dark background colours, and text colours that are legible on them.
#pragma once

#include <QColor>

class QLabel;

namespace drillwave {

/// Returns true if a background is so dark that text on it should be light.
inline bool isDark(const QColor& ground) {
    return ground.lightness() < 128;
}

// Appearance of a warning text.

/// Shows a label in bold and in a warning colour if `warning`, otherwise in the normal style. Its text must
/// express the warning too, because not every user sees the colour.
void setWarning(QLabel& label, bool warning);

}  // namespace drillwave
