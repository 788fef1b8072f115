// SPDX-License-Identifier: GPL-3.0-or-later
// Replacements of parts of a text, made all at once.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace drillwave {

/// `length` bytes at `offset` are replaced; insertions at the same place keep their order.
struct TextEdit {
    std::size_t offset = 0;
    std::size_t length = 0;
    std::string replacement;
};

/// The text with the edits made. Where two overlap, what either removes is removed, and both replacements
/// stand, that of the earlier offset first.
std::string edited(std::string_view text, std::vector<TextEdit> edits);

}  // namespace drillwave
