// SPDX-License-Identifier: GPL-3.0-or-later
// Replacement of several parts of a text at once.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace drillwave {

/// Replacement of `length` bytes of a text from the byte `offset`; an insertion if `length` is 0. Insertions
/// at the same offset keep their order.
struct TextEdit {
    std::size_t offset = 0;
    std::size_t length = 0;
    std::string replacement;
};

/// Returns the text with all edits made; offsets refer to the original text. If two edits overlap, the bytes
/// of both are removed, and both replacements are written, that of the lower offset first.
std::string edited(std::string_view text, std::vector<TextEdit> edits);

}  // namespace drillwave
