// SPDX-License-Identifier: GPL-3.0-or-later
// Search for words in all chapters of the manual.
#pragma once

#include <QList>
#include <QStringList>

#include "core/text/languages.h"
#include "ui/help/manual_book.h"

namespace drillwave {

/// Section of the manual that contains all words of a search.
struct ManualHit {
    ManualPlace place;
    QString chapter;  ///< title of the chapter
    QString heading;  ///< heading of the section as shown
    QString excerpt;  ///< text around the first of the words sought
    bool inHeading = false;
    int count = 0;  ///< number of occurrences of all words
};

/// Returns the words of a search text; words between quotes count as one.
QStringList soughtWords(const QString& typed);

/// Returns short English texts of the window whose translation contains `words`, the shortest translation
/// first. With them a search finds chapters that exist only in English. Empty if `words` is empty.
QStringList englishOf(const QString& words, const Language& language);

/// Index of all sections of the manual as plain text.
class ManualSearch {
  public:
    explicit ManualSearch(const ManualBook& book);

    /// Returns the sections that contain every word, ignoring case: first those with all words in the
    /// heading, then by number of occurrences. At most 200 sections; none without words.
    QList<ManualHit> find(const QStringList& words) const;

  private:
    struct Section {
        ManualPlace place;
        QString chapter;
        QString heading;
        QString text;
    };
    QList<Section> m_sections;
};

}  // namespace drillwave
