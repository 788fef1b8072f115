// SPDX-License-Identifier: GPL-3.0-or-later
// A sentence for people that leaves the core in parts, so that a window can say it in the user's language.
#pragma once

#include <string>
#include <vector>

namespace drillwave {

/// A pattern such as "%1: cannot be written: %2", in English, and what stands for %1, %2 and so on.
struct Message {
    const char* pattern = "";  ///< marked by translatable()
    std::vector<std::string> arguments;

    bool isEmpty() const { return *pattern == '\0'; }
    /// The sentence in English.
    std::string text() const;
};

/// The pattern; `context` is "drillwave::Message". By it the catalogues of the window find what there is to
/// translate.
constexpr const char* translatable(const char* /*context*/, const char* pattern) {
    return pattern;
}

}  // namespace drillwave
