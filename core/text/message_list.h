// SPDX-License-Identifier: GPL-3.0-or-later
// Messages of several and of so many.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/text/message.h"

namespace drillwave {

/// A list with one more behind it, as `pattern` ("%1, %2") joins them; the one alone where the list is empty.
inline Message joined(Message list, const char* pattern, Message next) {
    if (list.isEmpty()) return next;
    return {pattern, {std::move(list), std::move(next)}};
}

/// All of them in a line, "; " between; empty where there are none.
inline Message inOneLine(std::vector<Message> messages) {
    Message line;
    for (Message& message : messages) line = joined(std::move(line), "%1; %2", std::move(message));
    return line;
}

/// "1 point", "8 points": a pattern for one and one for all other numbers.
inline Message counted(std::uint64_t count, const char* one, const char* several) {
    return {count == 1 ? one : several, {std::to_string(count)}};
}

}  // namespace drillwave
