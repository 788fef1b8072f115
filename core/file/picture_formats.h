// SPDX-License-Identifier: GPL-3.0-or-later
// The formats in which pictures are written, and what a command asks for.
#pragma once

#include <array>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace drillwave {

/// The endings of their files.
inline constexpr std::array<std::string_view, 3> pictureFormats{"png", "svg", "pdf"};

/// Pictures to be drawn of one thing.
struct PictureOrder {
    std::string stem;                  ///< of their names: "t38" for t38.png
    std::vector<std::string> formats;  ///< of pictureFormats
    std::stop_token stop;              ///< ends the drawing between two pictures
};

}  // namespace drillwave
