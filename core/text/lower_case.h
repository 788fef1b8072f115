// SPDX-License-Identifier: GPL-3.0-or-later
// Words that are alike but for capitals.
#pragma once

#include <string>

namespace drillwave {

/// A to Z as small letters, whatever the locale; other characters stay.
inline std::string lowerCase(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

}  // namespace drillwave
