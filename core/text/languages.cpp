// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/languages.h"

#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <list>
#include <sstream>

#include "core/text/catalogue_texts.h"

namespace drillwave {

namespace {

using Texts = std::map<std::string, std::string, std::less<>>;

/// Reads a catalogue; of two contexts that have a text the first counts.
Texts readCatalogue(std::string_view xml) {
    std::istringstream stream{std::string(xml)};
    boost::property_tree::ptree tree;
    boost::property_tree::read_xml(stream, tree);
    Texts texts;
    for (const auto& [contextTag, context] : tree.get_child("TS"))
        for (const auto& [tag, message] : context) {
            if (tag != "message") continue;
            const auto translation = message.get<std::string>("translation", "");
            if (!translation.empty()) texts.emplace(message.get<std::string>("source"), translation);
        }
    return texts;
}

class LanguageStyle : public ReadingStyle {
  public:
    explicit LanguageStyle(const Language& language) : m_language(language) {}

    /// All languages but English have the comma.
    std::string number(double value, int digits) const override {
        std::string text = ReadingStyle::number(value, digits);
        std::ranges::replace(text, '.', ',');
        return text;
    }
    std::string patternFor(const std::string& english) const override {
        return inLanguage(m_language, english);
    }
    std::string language() const override { return std::string(m_language.code); }

    const Language& m_language;
};

}  // namespace

const Texts& textsOf(const Language& language) {
    static std::map<std::string_view, Texts> read;
    const auto there = read.find(language.code);
    if (there != read.end()) return there->second;
    const auto* const source = std::ranges::find(catalogueTexts, language.code, &CatalogueText::code);
    return read[language.code] = source == std::end(catalogueTexts) ? Texts() : readCatalogue(source->xml);
}

std::string inLanguage(const Language& language, const std::string& english) {
    if (isEnglish(language)) return english;
    const Texts& texts = textsOf(language);
    const auto found = texts.find(english);
    return found == texts.end() ? english : found->second;
}

const ReadingStyle& styleOf(const Language& language) {
    if (isEnglish(language)) return plainStyle();
    static std::list<LanguageStyle> styles;
    for (const LanguageStyle& style : styles)
        if (style.m_language.code == language.code) return style;
    return styles.emplace_back(language);
}

}  // namespace drillwave
