// SPDX-License-Identifier: GPL-3.0-or-later
// Light and dark grounds: which colours can be read on them.
#pragma once

#include <QColor>

namespace drillwave {

/// Whether what stands on that ground is to be light.
inline bool isDark(const QColor& ground) {
    return ground.lightness() < 128;
}

}  // namespace drillwave
