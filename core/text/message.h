// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences that can be translated: the core returns them in parts, and the window puts them together in the
// user's language.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace drillwave {

/// Sentence with numbered gaps, such as "%1: cannot be written: %2", and the texts that fill them. A gap is
/// filled by another message, which is translated, or by a name or number, which is not.
struct Message {
    std::string pattern;
    std::vector<Message> arguments;
    bool isWords = false;  ///< whether `pattern` is a name or a number, which is never translated

    Message() = default;
    /// Makes a sentence from an English pattern, marked by translatable(), and the texts for its gaps %1, %2,
    /// …
    Message(const char* english, std::vector<Message> places = {})
        : pattern(english), arguments(std::move(places)) {}
    /// Makes a message that is a name or a number, the same in every language.
    Message(std::string words) : pattern(std::move(words)), isWords(true) {}
    /// Returns a message for a word from a table in the code, such as the label of a parameter. The word is
    /// translated like a sentence. The table must mark it by translatable().
    static Message ofTable(std::string_view word) { return std::string(word).c_str(); }

    bool operator==(const Message&) const = default;

    bool isEmpty() const { return pattern.empty(); }
    /// Returns the complete sentence in English.
    std::string text() const;
    /// Returns the complete sentence, with every pattern replaced by the result of `say`, which translates
    /// the pattern.
    std::string said(const std::function<std::string(const std::string& pattern)>& say) const;
};

/// Returns the pattern unchanged, and marks it for translation. The catalogues list it in the context
/// "drillwave::Message".
constexpr const char* translatable(const char* pattern) {
    return pattern;
}

/// Returns a sentence preceded by the name of its subject: "out.csv: exists already".
inline Message about(Message name, Message sentence) {
    return {"%1: %2", {std::move(name), std::move(sentence)}};
}
/// Returns several sentences, each preceded by the name of their common subject: "out.csv: exists already".
std::vector<Message> eachAbout(const Message& name, std::vector<Message> sentences);

// Lists and counts in messages.

/// Returns a list of messages with one more message at its end, joined by `pattern` ("%1, %2"). If the list
/// is empty, returns only the new message.
inline Message joined(Message list, const char* pattern, Message next) {
    if (list.isEmpty()) return next;
    return {pattern, {std::move(list), std::move(next)}};
}

/// Returns all messages in one line, separated by "; "; empty if there are none.
inline Message inOneLine(std::vector<Message> messages) {
    Message line;
    for (Message& message : messages) line = joined(std::move(line), "%1; %2", std::move(message));
    return line;
}

/// Returns a count with its noun: "1 point" from the pattern `one`, else "8 points" from the pattern
/// `several`.
inline Message counted(std::uint64_t count, const char* one, const char* several) {
    return {count == 1 ? one : several, {std::to_string(count)}};
}

}  // namespace drillwave
