// SPDX-License-Identifier: GPL-3.0-or-later
// A language that shows which words a text takes from the catalogues.
#pragma once

#include <QRegularExpression>
#include <QString>
#include <QStringList>

#include <string>

#include "core/text/handy_text.h"

namespace drillwave::test {

/// A language in which every text of the program is between marks; texts outside are in all languages.
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

/// The words of a text, where dots and underscores join them to names.
inline QStringList wordsOf(const QString& text) {
    QStringList words;
    static const QRegularExpression word(QStringLiteral("[\\p{L}_.]*\\p{L}{3,}[\\p{L}_.]*"));
    for (const auto& found : word.globalMatch(text)) words << found.captured();
    return words;
}

/// Returns the words of a text in MarkedStyle that are not between marks.
inline QStringList wordsOutsideMarks(QString text) {
    static const QRegularExpression marked(QStringLiteral("⟦[^⟧]*⟧"));
    return wordsOf(text.replace(marked, QStringLiteral("\n")));
}

}  // namespace drillwave::test
