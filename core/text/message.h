// SPDX-License-Identifier: GPL-3.0-or-later
// A sentence for people that leaves the core in parts, so that a window can say it in the user's language.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace drillwave {

/// A pattern such as "%1: cannot be written: %2", in English, and what stands for %1, %2 and so on: other
/// sentences, or names and numbers, which are the same in every language.
struct Message {
    std::string pattern;
    std::vector<Message> arguments;
    bool isWords = false;  ///< the pattern is a name or a number, said as it is

    Message() = default;
    /// A pattern, marked by translatable().
    Message(const char* english, std::vector<Message> places = {})
        : pattern(english), arguments(std::move(places)) {}
    /// A name or a number.
    Message(std::string words) : pattern(std::move(words)), isWords(true) {}
    /// A text that the catalogues have: a word of a table of the core, or a sentence that was marked where it
    /// was made.
    static Message ofTable(std::string_view word) { return std::string(word).c_str(); }

    bool operator==(const Message&) const = default;

    bool isEmpty() const { return pattern.empty(); }
    /// The sentence in English.
    std::string text() const;
    /// The sentence with `say` of every pattern in it.
    std::string said(const std::function<std::string(const std::string& pattern)>& say) const;
};

/// Returns the pattern, and marks it for the catalogues of the window, which have it in the context
/// "drillwave::Message".
constexpr const char* translatable(const char* pattern) {
    return pattern;
}

/// Returns a sentence after the name of its subject: "out.csv: exists already".
inline Message about(Message name, Message sentence) {
    return {"%1: %2", {std::move(name), std::move(sentence)}};
}
/// Returns the same for several sentences on one subject.
std::vector<Message> eachAbout(const Message& name, std::vector<Message> sentences);

// Messages of several and of so many.

/// A list with one more behind it, as `pattern` ("%1, %2") joins them; the one alone where the list is empty.
inline Message joined(Message list, const char* pattern, Message next) {
    if (list.isEmpty()) return next;
    return {pattern, {std::move(list), std::move(next)}};
}

/// Returns all in one line, "; " between; empty if there are none.
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
