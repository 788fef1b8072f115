// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/yaml_tree.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <sstream>

#include "core/text/text_input.h"

namespace drillwave {
namespace {

constexpr std::size_t maximumDepth = 32;
constexpr std::size_t maximumNodes = 400000;

/// Thrown from inside the parser to stop it at once.
struct Refusal {
    YamlProblem problem;
};

/// No sensible file leaves this many brackets open, not even in comments; the parser would look far ahead for
/// each of them before it says the first.
constexpr int maximumOpenBrackets = 1000;

/// The bracket that is one too many, or npos.
std::size_t excessiveBracket(std::string_view text) {
    int open = 0;
    for (std::size_t at = text.find_first_of("[]{}"); at != std::string_view::npos;
         at = text.find_first_of("[]{}", at + 1)) {
        const bool opens = text[at] == '[' || text[at] == '{';
        open = std::max(0, open + (opens ? 1 : -1));
        if (open > maximumOpenBrackets) return at;
    }
    return std::string_view::npos;
}

/// The first tab before the first word of a line, down to the line behind a place; npos where there is none.
std::size_t tabInIndentation(std::string_view text, std::size_t place) {
    const std::size_t end = std::min(text.find('\n', place), text.size());
    for (std::size_t line = 0; line < end;) {
        const std::size_t word = std::min(text.find_first_not_of(" \t", line), text.size());
        const std::size_t tab = text.substr(line, word - line).find('\t');
        if (tab != std::string_view::npos && word < text.size() && text[word] != '\n' && text[word] != '#' &&
            text[word] != '\r')
            return line + tab;
        const std::size_t next = text.find('\n', line);
        if (next == std::string_view::npos) break;
        line = next + 1;
    }
    return std::string_view::npos;
}

Message tooDeep() {
    return {translatable("more than %1 levels of nesting are not accepted"), {std::to_string(maximumDepth)}};
}

/// The parser's words; it may quote half a character.
std::string asciiOnly(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) >= 0x80) c = '?';
    return text;
}

/// Builds the tree from the parser's events. The parser is left at the first thing that is refused, so that
/// neither nesting nor aliases cost more than they are worth.
class TreeBuilder final : public YAML::EventHandler {
  public:
    explicit TreeBuilder(std::string_view text) : m_text(text) {}

    YamlNode takeRoot() { return std::move(m_root); }

    void OnDocumentStart(const YAML::Mark&) override {}
    void OnDocumentEnd() override {}
    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        add(node(YamlKind::null, mark, "", anchor));
    }
    void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
        refuse(mark, translatable("an alias (*) is not accepted here: write the value itself"));
    }
    void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  const std::string& value) override {
        YamlNode scalar = node(YamlKind::scalar, mark, tag, anchor);
        scalar.text = value;
        add(std::move(scalar));
    }
    void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value style) override {
        open(YamlKind::sequence, mark, tag, anchor, style);
    }
    void OnSequenceEnd() override { close(); }
    void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value style) override {
        open(YamlKind::map, mark, tag, anchor, style);
    }
    void OnMapEnd() override { close(); }

  private:
    std::size_t offsetOf(const YAML::Mark& mark) const {
        const std::size_t position = mark.pos < 0 ? 0 : static_cast<std::size_t>(mark.pos);
        return std::min(position + byteOrderMarkLength(m_text), m_text.size());
    }

    /// The parser takes a quote that is never closed to end with the file.
    bool isClosed(std::size_t quote) const {
        const char mark = m_text[quote];
        for (std::size_t at = quote + 1; at < m_text.size(); ++at) {
            const bool escaped = mark == '"' ? m_text[at] == '\\' : m_text.substr(at).starts_with("''");
            if (escaped)
                ++at;
            else if (m_text[at] == mark)
                return true;
        }
        return false;
    }

    [[noreturn]] void refuse(const YAML::Mark& mark, Message reason) const {
        throw Refusal{{offsetOf(mark), std::move(reason), true}};
    }

    YamlNode node(YamlKind kind, const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
        if (anchor != 0)
            refuse(mark, translatable("an anchor (&) is not accepted here: write the value itself"));
        const std::size_t offset = offsetOf(mark);
        // A plain scalar has the tag "?", a quoted one "!", as has one with an explicit "!".
        const bool quoted = tag == "!" && offset < m_text.size() && m_text[offset] != '!';
        if (!tag.empty() && tag != "?" && !quoted)
            refuse(mark, translatable("a tag (!) is not accepted here: write only the value"));
        if (quoted && (m_text[offset] == '"' || m_text[offset] == '\'') && !isClosed(offset))
            throw Refusal{
                {offset, translatable("not YAML: the quote that begins here is not closed"), false}};
        if (++m_count > maximumNodes) refuse(mark, translatable("there are too many values from here on"));
        YamlNode result;
        result.kind = kind;
        result.offset = static_cast<std::uint32_t>(offset);
        return result;
    }

    void open(YamlKind kind, const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
              YAML::EmitterStyle::value style) {
        if (m_open.size() >= maximumDepth) refuse(mark, tooDeep());
        YamlNode collection = node(kind, mark, tag, anchor);
        collection.flow = style == YAML::EmitterStyle::Flow;
        m_open.push_back(std::move(collection));
    }

    void close() {
        YamlNode finished = std::move(m_open.back());
        m_open.pop_back();
        add(std::move(finished));
    }

    void add(YamlNode finished) {
        if (m_open.empty()) {
            m_root = std::move(finished);
            return;
        }
        YamlNode& parent = m_open.back();
        const bool isKey = parent.kind == YamlKind::map && parent.children.size() % 2 == 0;
        if (isKey && finished.kind != YamlKind::scalar)
            throw Refusal{{finished.offset, "a key must be a plain name", true}};
        parent.children.push_back(std::move(finished));
    }

    std::string_view m_text;
    std::vector<YamlNode> m_open;
    YamlNode m_root;
    std::size_t m_count = 0;
};

/// Refuses whatever follows the first document.
class NoSecondDocument final : public YAML::EventHandler {
  public:
    explicit NoSecondDocument(std::size_t byteOrderMark) : m_byteOrderMark(byteOrderMark) {}
    void OnDocumentStart(const YAML::Mark& mark) override {
        throw Refusal{{static_cast<std::size_t>(std::max(mark.pos, 0)) + m_byteOrderMark,
                       "a second document begins here, one file holds one scenario", true}};
    }
    void OnDocumentEnd() override {}
    void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
    void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
    void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t, const std::string&) override {}
    void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                         YAML::EmitterStyle::value) override {}
    void OnSequenceEnd() override {}
    void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                    YAML::EmitterStyle::value) override {}
    void OnMapEnd() override {}

  private:
    std::size_t m_byteOrderMark;
};

}  // namespace

const YamlNode* YamlNode::valueOf(std::string_view key) const {
    if (kind != YamlKind::map) return nullptr;
    for (std::size_t i = 0; i + 1 < children.size(); i += 2)
        if (children[i].text == key) return &children[i + 1];
    return nullptr;
}

const std::string* YamlNode::textOf(std::string_view key) const {
    const YamlNode* value = valueOf(key);
    return value && value->kind == YamlKind::scalar ? &value->text : nullptr;
}

YamlTree parseYaml(std::string_view text) {
    YamlTree tree;
    if (const std::size_t bracket = excessiveBracket(text); bracket != std::string_view::npos) {
        tree.problem = {bracket, tooDeep(), true};
        return tree;
    }
    TreeBuilder builder(text);
    try {
        std::istringstream in{std::string(text)};
        YAML::Parser parser(in);
        parser.HandleNextDocument(builder);
        NoSecondDocument nothing(byteOrderMarkLength(text));
        parser.HandleNextDocument(nothing);
        tree.root = builder.takeRoot();
    } catch (const Refusal& refusal) {
        tree.problem = refusal.problem;
    } catch (const YAML::Exception& error) {
        const std::size_t position = error.mark.pos < 0 ? 0 : static_cast<std::size_t>(error.mark.pos);
        const std::size_t offset = std::min(position + byteOrderMarkLength(text), text.size());
        if (const std::size_t tab = tabInIndentation(text, offset); tab != std::string_view::npos) {
            tree.problem = {
                tab, translatable("not YAML: this line is indented by a tab; indent it by blanks"), false};
            return tree;
        }
        tree.problem = {offset, {translatable("not YAML: %1"), {asciiOnly(error.msg)}}, false};
    }
    return tree;
}

}  // namespace drillwave
