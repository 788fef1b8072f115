// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/manual_search.h"

#include <QRegularExpression>
#include <algorithm>
#include <utility>

#include "core/manual/markdown.h"
#include "core/text/languages.h"

namespace drillwave {
namespace {

constexpr qsizetype mostHits = 200;
constexpr qsizetype excerptLength = 90;  // characters
constexpr qsizetype leadLength = 30;     // of them before the word

QString plain(const ManualBlock& block) {
    using Kind = ManualBlock::Kind;
    if (block.kind == Kind::code) return QString::fromStdString(block.text);
    QString text = QString::fromStdString(withoutMarks(block.text));
    for (const auto& row : block.rows)
        for (const std::string& cell : row) text += QString::fromStdString(withoutMarks(cell)) + u' ';
    return text.remove(u'`');
}

QString excerptOf(const QString& text, const QString& word) {
    const qsizetype at = std::max<qsizetype>(text.indexOf(word, 0, Qt::CaseInsensitive), 0);
    qsizetype begin = std::max<qsizetype>(at - leadLength, 0);
    while (begin > 0 && !text[begin - 1].isSpace()) --begin;
    QString excerpt = text.mid(begin, excerptLength).simplified();
    if (begin > 0) excerpt.prepend(QStringLiteral("… "));
    if (begin + excerptLength < text.size()) excerpt += QStringLiteral(" …");
    return excerpt;
}

bool hasAll(const QString& text, const QStringList& words) {
    return std::ranges::all_of(
        words, [&text](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

}  // namespace

QStringList soughtWords(const QString& typed) {
    static const QRegularExpression word(QStringLiteral("\"([^\"]+)\"?|(\\S+)"));
    QStringList words;
    for (auto found = word.globalMatch(typed); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        const QString text = match.captured(1).isEmpty() ? match.captured(2) : match.captured(1).simplified();
        if (!text.isEmpty() && text != QStringLiteral("\"")) words.append(text);
    }
    return words;
}

QStringList englishOf(const QString& words, const Language& language) {
    constexpr qsizetype mostWords = 4;
    if (words.trimmed().isEmpty()) return {};
    const QRegularExpression asWords(
        QStringLiteral("\\b") + QRegularExpression::escape(words.simplified()) + QStringLiteral("\\b"),
        QRegularExpression::CaseInsensitiveOption | QRegularExpression::UseUnicodePropertiesOption);
    QList<std::pair<qsizetype, QString>> found;  // by the length of the translation
    for (const auto& [english, translation] : textsOf(language)) {
        const QString text = QString::fromStdString(translation);
        if (text.count(u' ') < mostWords && text.contains(asWords))
            found.append({text.size(), QString::fromStdString(english)});
    }
    std::ranges::stable_sort(found, {}, &std::pair<qsizetype, QString>::first);
    QStringList texts;
    for (const auto& each : found) texts.append(each.second);
    return texts;
}

ManualSearch::ManualSearch(const ManualBook& book) {
    for (const BookChapter& chapter : book.chapters())
        for (const ManualBlock& block : chapter.blocks) {
            const QString text = plain(block);
            if (block.kind == ManualBlock::Kind::heading)
                m_sections.append(
                    {{chapter.name, block.level == 1 ? QString() : text}, chapter.title, text, {}});
            else if (!m_sections.isEmpty())
                m_sections.last().text += text + u'\n';
        }
}

QList<ManualHit> ManualSearch::find(const QStringList& words) const {
    QList<ManualHit> hits;
    if (words.isEmpty()) return hits;
    for (const Section& section : m_sections) {
        const QString all = section.heading + u'\n' + section.text;
        if (!hasAll(all, words)) continue;
        ManualHit hit{section.place, section.chapter, section.heading, excerptOf(section.text, words.first()),
                      hasAll(section.heading, words)};
        for (const QString& word : words) hit.count += int(all.count(word, Qt::CaseInsensitive));
        hits.append(hit);
    }
    std::ranges::stable_sort(hits, [](const ManualHit& a, const ManualHit& b) {
        return a.inHeading != b.inHeading ? a.inHeading : a.count > b.count;
    });
    if (hits.size() > mostHits) hits.resize(mostHits);
    return hits;
}

}  // namespace drillwave
