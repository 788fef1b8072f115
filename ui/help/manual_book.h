// SPDX-License-Identifier: GPL-3.0-or-later
// The chapters as the help window has them, and which headings they have.
#pragma once

#include <QList>
#include <QString>
#include <vector>

#include "core/manual/chapter.h"
#include "core/manual/markdown.h"
#include "core/text/languages.h"
#include "ui/help/help_topic.h"

namespace drillwave {

/// A chapter with its headings as they are shown.
struct BookChapter {
    QString name;
    QString title;
    QString markdown;
    std::vector<ManualBlock> blocks;  ///< of it
    struct Heading {
        QString text;
        int level = 1;
    };
    QList<Heading> headings;  ///< in order, that of the chapter first
    QStringList equations;    ///< "(T1)", the equations in it
};

/// The chapters of core in a language, with what a window adds to them.
class ManualBook {
  public:
    explicit ManualBook(const Language& language);

    /// In the order of a list of contents.
    const QList<BookChapter>& chapters() const { return m_chapters; }
    /// Or nullptr.
    const BookChapter* find(const QString& name) const;
    /// Whether there is such a place.
    bool has(const ManualPlace& place) const;
    /// Appends Markdown to a chapter of the book and replaces what was appended before.
    void append(const QString& name, const QString& markdown);

  private:
    QList<BookChapter> m_chapters;
};

}  // namespace drillwave
