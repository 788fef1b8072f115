// SPDX-License-Identifier: GPL-3.0-or-later
// Artificial language that shows which words of a text come from the catalogues.
#pragma once

#include <QRegularExpression>
#include <QString>
#include <QStringList>

#include <string>

#include "core/text/handy_text.h"

namespace drillwave::test {

/// Style that puts every translated text between marks, ⟦ and ⟧; words outside the marks are not translated.
class MarkedStyle : public ReadingStyle {
  public:
    std::string patternFor(const std::string& english) const override {
        QString text;
        for (const QString& part :
             QString::fromStdString(english).split(QRegularExpression("(?=%\\d)|(?<=%\\d)")))
            text += part.startsWith(u'%') && part.size() == 2 ? part : QStringLiteral("⟦%1⟧").arg(part);
        return text.toStdString();
    }
    std::string language() const override { return "mark"; }
};

/// Returns the words of a text of at least three letters. Dots and underscores join words to names.
inline QStringList wordsOf(const QString& text) {
    QStringList words;
    static const QRegularExpression word(QStringLiteral("[\\p{L}_.]*\\p{L}{3,}[\\p{L}_.]*"));
    for (const auto& found : word.globalMatch(text)) words << found.captured();
    return words;
}

/// Returns the words of a text in MarkedStyle that are not between marks, that is, not translated.
inline QStringList wordsOutsideMarks(QString text) {
    static const QRegularExpression marked(QStringLiteral("⟦[^⟧]*⟧"));
    return wordsOf(text.replace(marked, QStringLiteral("\n")));
}

}  // namespace drillwave::test
