// SPDX-License-Identifier: GPL-3.0-or-later
// Chapters of the manual with their headings, as the help window shows them.
#pragma once

#include <QList>
#include <QString>
#include <vector>

#include "core/manual/chapter.h"
#include "core/manual/markdown.h"
#include "core/text/languages.h"
#include "ui/help/help_topic.h"

namespace drillwave {

/// Chapter of the manual, with its headings as the help window shows them.
struct BookChapter {
    QString name;
    QString title;
    QString markdown;
    std::vector<ManualBlock> blocks;  ///< blocks parsed from `markdown`
    struct Heading {
        QString text;
        int level = 1;
    };
    QList<Heading> headings;  ///< all headings in order, first that of the chapter
    QStringList equations;    ///< numbers of its equations, "(T1)"
};

/// Manual in one language: the built-in chapters, and text that the window appends.
class ManualBook {
  public:
    explicit ManualBook(const Language& language);

    /// Returns all chapters in the order of the table of contents.
    const QList<BookChapter>& chapters() const { return m_chapters; }
    /// Returns the chapter of that name, or nullptr if there is none.
    const BookChapter* find(const QString& name) const;
    /// Returns true if the manual has the chapter of `place` and, in it, the heading or equation of `place`.
    bool has(const ManualPlace& place) const;
    /// Appends Markdown to the chapter `name`; does nothing without such a chapter.
    void append(const QString& name, const QString& markdown);

  private:
    QList<BookChapter> m_chapters;
};

}  // namespace drillwave
