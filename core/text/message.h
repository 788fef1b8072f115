// SPDX-License-Identifier: GPL-3.0-or-later
// A sentence for people that leaves the core in parts, so that a window can say it in the user's language.
#pragma once

#include <string>
#include <vector>

namespace drillwave {

/// A pattern such as "%1: cannot be written: %2", in English, and what stands for %1, %2 and so on.
struct Message {
    const char* pattern = "";
    std::vector<std::string> arguments;

    bool isEmpty() const { return *pattern == '\0'; }
    /// The sentence in English.
    std::string text() const;
};

}  // namespace drillwave
