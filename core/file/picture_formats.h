// SPDX-License-Identifier: GPL-3.0-or-later
// The formats in which pictures are written.
#pragma once

#include <array>
#include <string_view>

namespace drillwave {

/// The endings of their files.
inline constexpr std::array<std::string_view, 3> pictureFormats{"png", "svg", "pdf"};

}  // namespace drillwave
