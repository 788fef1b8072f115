// SPDX-License-Identifier: GPL-3.0-or-later
// Words sought in all chapters of the manual.
#pragma once

#include <QList>
#include <QStringList>

#include "core/text/languages.h"
#include "ui/help/manual_book.h"

namespace drillwave {

/// A section that has all the words.
struct ManualHit {
    ManualPlace place;
    QString chapter;  ///< its title
    QString heading;  ///< as it is shown
    QString excerpt;  ///< some words around the first of those that are sought
    bool inHeading = false;
    int count = 0;  ///< how often they occur
};

/// The words of what was typed; between quotes several are one.
QStringList soughtWords(const QString& typed);

/// Returns short English texts of the window whose translation has these words, because some chapters are in
/// English; the shortest first, none for no words.
QStringList englishOf(const QString& words, const Language& language);

/// The sections of all chapters as plain text, read once.
class ManualSearch {
  public:
    explicit ManualSearch(const ManualBook& book);

    /// Returns sections that have every word, in either case: first those with all of them in their heading,
    /// then those with the most hits; at most as many as a list can show. None without words.
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
