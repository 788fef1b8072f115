// SPDX-License-Identifier: GPL-3.0-or-later
// Notices above a page: why it is empty, and what it shows instead.
#pragma once

#include <QPointer>
#include <optional>

#include "ui/document/document.h"
#include "ui/job/solved_blow.h"
#include "ui/window/notice.h"

namespace drillwave {

class Page;
class PageTabs;

// Notice of why a page is not available for this scenario, and which page has the answer instead.

/// Notice of why a page is not available for the scenario. It disappears when another page is shown, or when
/// this page becomes available again.
class ElsewhereNotice : public Notice {
    Q_OBJECT

  public:
    /// Makes the notice. The pages must outlive it.
    explicit ElsewhereNotice(PageTabs& pages, QWidget* parent = nullptr);

  private:
    void tell(Page* page);

    QPushButton* m_show;  // button that opens the page with the answer; hidden if there is none
    QPointer<Page> m_page;
};

// Notice that pages show one blow of a sequence under a feed force, with a button to return to the single
// blow.

/// Notice that pages show one blow of a sequence instead of the single blow. It stores which blow, until it
/// is closed or reset. It is visible above the pages that can show that blow.
class MarchedNotice : public Notice {
    Q_OBJECT

  public:
    /// Makes the notice. The pages must outlive it.
    explicit MarchedNotice(PageTabs& pages, QWidget* parent = nullptr);

    /// Shows this blow of a sequence on the pages that can; `what` describes it in words.
    void open(const MarchedQuestion& blow, const QString& what);
    /// Shows the single blow again, instead of one of a sequence. Must be called when the scenario changes.
    void forget();
    /// Returns the blow of a sequence that a page should show; nothing for the single blow.
    std::optional<MarchedQuestion> blowOf(const Page& page) const;

  signals:
    /// Emitted when the user asks for the single blow again.
    void singleWanted();

  private:
    void follow();

    PageTabs& m_pages;
    std::optional<MarchedQuestion> m_blow;
};

// Notice of which value was taken from a plot, with a button to undo it.

/// Notice that a value was taken from a plot into the scenario, with a button to undo this. It disappears
/// with the next change of the scenario.
class TakenNotice : public Notice {
    Q_OBJECT

  public:
    /// Makes the notice. The document must outlive it, as must the pages passed to follow().
    explicit TakenNotice(Document& document, QWidget* parent = nullptr);
    /// Starts listening to every page. Call it once, when all pages exist.
    void follow(PageTabs& pages);

  private:
    Document& m_document;
    int m_step = -1;  // index of the undo stack after the reported step
};

// Notice of why a page of waves shows a coarser string, with a button to round lengths so that it shows all
// waves.

/// Notice shown while the waves on the visible page are too many to be stored, if rounding the section
/// lengths to 10 mm may help.
class WavesNotice : public Notice {
    Q_OBJECT

  public:
    /// Makes the notice. Document and pages must outlive it.
    WavesNotice(Document& document, PageTabs& pages, QWidget* parent = nullptr);

    void present(const SolvedBlow& blow);

  private:
    QString changesText(const DrillString& rounded) const;

    Document& m_document;
};

}  // namespace drillwave
