// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/catalogue.h"

#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <sstream>

#include "core/text/catalogue_texts.h"

namespace drillwave {

namespace {

using Texts = std::map<std::string, std::string, std::less<>>;

/// Of two contexts that have a text the first counts.
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

}  // namespace drillwave
