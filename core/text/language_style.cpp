// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/language_style.h"

#include <algorithm>
#include <list>

#include "core/text/catalogue.h"

namespace drillwave {

namespace {

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

const ReadingStyle& styleOf(const Language& language) {
    if (isEnglish(language)) return plainStyle();
    static std::list<LanguageStyle> styles;
    for (const LanguageStyle& style : styles)
        if (style.m_language.code == language.code) return style;
    return styles.emplace_back(language);
}

}  // namespace drillwave
