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

/// What pictures beside the file of a study say of themselves, figures of the paper, and reports: by this and
/// their names a later run knows them for what an earlier one left.
inline constexpr std::string_view studyPictureMark = "Drillwave study";
inline constexpr std::string_view figureMark = "Drillwave figure";
inline constexpr std::string_view reportMark = "Drillwave report";

/// Pictures to be drawn of one thing.
struct PictureOrder {
    std::string stem;                  ///< of their names: "t38" for t38.png
    std::vector<std::string> formats;  ///< of pictureFormats
    std::stop_token stop;              ///< ends the drawing between two pictures
    std::string mark = "Drillwave";    ///< who made them, in their properties
};

}  // namespace drillwave
