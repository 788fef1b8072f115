// SPDX-License-Identifier: GPL-3.0-or-later
// The icon of the program, drawn from resources/icons/drillwave.svg.
#pragma once

#include <QIcon>
#include <QImage>
#include <array>

namespace drillwave {

/// Widths in pixels in which desktops ask for icons of programs.
inline constexpr std::array<int, 8> iconWidths{16, 22, 24, 32, 48, 64, 128, 256};

/// A square of so many pixels, with transparent corners. Needs no application object.
QImage programImage(int width);

/// Returns the icon in all of iconWidths.
QIcon programIcon();

}  // namespace drillwave
