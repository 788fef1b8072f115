// SPDX-License-Identifier: GPL-3.0-or-later
// Icon of the program, drawn from resources/icons/drillwave.svg.
#pragma once

#include <QIcon>
#include <QImage>
#include <array>

namespace drillwave {

/// Widths in which desktops request program icons [px].
inline constexpr std::array<int, 8> iconWidths{16, 22, 24, 32, 48, 64, 128, 256};

/// Returns the icon as a square image of the given width [px], with transparent corners. Needs no application
/// object.
QImage programImage(int width);

/// Returns the icon with all sizes of iconWidths.
QIcon programIcon();

}  // namespace drillwave
