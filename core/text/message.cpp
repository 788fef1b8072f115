// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/message.h"

#include <cassert>

namespace drillwave {

std::string Message::text() const {
    return said([](const std::string& english) { return english; });
}

std::string Message::said(const std::function<std::string(const std::string&)>& say) const {
    if (isWords || isEmpty()) return pattern;
    const std::string here = say(pattern);
    if (arguments.empty()) return here;  // a reason that a number or a name was put into stays as it is
    std::string sentence;
    for (std::size_t i = 0; i < here.size(); ++i) {
        const bool isPlace =
            here[i] == '%' && i + 1 < here.size() && here[i + 1] >= '1' && here[i + 1] <= '9';
        if (!isPlace) {
            sentence += here[i];
            continue;
        }
        const auto number = static_cast<std::size_t>(here[++i] - '1');
        assert(number < arguments.size());
        sentence += arguments[number].said(say);
    }
    return sentence;
}

std::vector<Message> eachAbout(const Message& name, std::vector<Message> sentences) {
    for (Message& sentence : sentences) sentence = about(name, std::move(sentence));
    return sentences;
}

}  // namespace drillwave
