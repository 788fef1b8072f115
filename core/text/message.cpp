// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/message.h"

#include <cassert>

namespace drillwave {

std::string Message::text() const {
    std::string text;
    for (const char* c = pattern; *c != '\0'; ++c) {
        if (*c != '%') {
            text += *c;
            continue;
        }
        const auto number = static_cast<std::size_t>(*++c - '1');
        assert(number < arguments.size());
        text += arguments[number];
    }
    return text;
}

}  // namespace drillwave
