// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/text_edit.h"

#include <algorithm>

namespace drillwave {

std::string edited(std::string_view text, std::vector<TextEdit> edits) {
    std::ranges::stable_sort(edits, {}, &TextEdit::offset);
    std::string result;
    std::size_t at = 0;
    for (const TextEdit& edit : edits) {
        const std::size_t offset = std::max(edit.offset, at);
        result += text.substr(at, offset - at);
        result += edit.replacement;
        at = std::max(offset, edit.offset + edit.length);
    }
    return result + std::string(text.substr(at));
}

}  // namespace drillwave
