// SPDX-License-Identifier: GPL-3.0-or-later
// Artificial language in which every translated text is marked and longer than in English. Unmarked texts are
// not translated; texts that are cut off could be cut off in other languages too.
#pragma once

#include <QRegularExpression>
#include <QString>
#include <QTranslator>

#include "ui/text/language.h"

namespace drillwave::test {

/// Returns a text as "⟦Save as ~~~⟧", a third longer. Marks are set around placeholders, so that their values
/// stay outside; accelerators, markup and line ends stay.
inline QString pseudo(const QString& source) {
    static const QRegularExpression kept(QStringLiteral("%L?\\d+|%n|</?\\w+>|\\n|;;"));
    static const QRegularExpression letter(QStringLiteral("\\p{L}"));
    QString text;
    const auto add = [&](const QString& words) {
        if (!words.contains(letter)) {
            text += words;
            return;
        }
        QString longer;
        for (qsizetype i = 0; i < (words.size() + 2) / 3; ++i) longer += i % 6 == 5 ? u' ' : u'~';
        text += QStringLiteral("⟦") + words + longer + QStringLiteral("⟧");
    };
    qsizetype from = 0;
    for (const QRegularExpressionMatch& match : kept.globalMatch(source)) {
        add(source.mid(from, match.capturedStart() - from));
        text += match.captured();
        from = match.capturedEnd();
    }
    add(source.mid(from));
    return text;
}

/// Returns the text outside all marks: values, and words that are not translated.
inline QString outsideMarks(const QString& text) {
    QString outside;
    int depth = 0;
    for (const QChar c : text) {
        if (c == u'⟦') ++depth;
        if (depth == 0) outside += c;
        if (c == u'⟧' && depth > 0) --depth;
    }
    return outside;
}

class PseudoTranslator : public QTranslator {
  public:
    QString translate(const char* /*context*/, const char* source, const char* /*disambiguation*/ = nullptr,
                      int /*count*/ = -1) const override {
        return EnglishTexts::areWanted() ? QString() : pseudo(QString::fromUtf8(source));
    }
    bool isEmpty() const override { return false; }
};

}  // namespace drillwave::test
