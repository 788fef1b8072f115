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

/// Notice that says why a page is not available for the present scenario, and which page to use instead. It
/// disappears when another page is shown, or when the page becomes available.
class ElsewhereNotice : public Notice {
    Q_OBJECT

  public:
    /// Creates the notice, which is shown when `pages` reports that a page does not apply to the scenario.
    /// The pages must outlive it.
    explicit ElsewhereNotice(PageTabs& pages, QWidget* parent = nullptr);

  private:
    void tell(Page* page);

    QPushButton* m_show;  // button that opens the page with the answer; hidden if there is none
    QPointer<Page> m_page;
};

// Notice that pages show one blow of a sequence under a feed force, with a button to return to the single
// blow.

/// Notice above the page that it shows one blow of a sequence under feed, not the usual single blow from
/// rest. The object remembers this blow until the notice is closed or forget() is called. It is visible only
/// above pages that can show such a blow.
class MarchedNotice : public Notice {
    Q_OBJECT

  public:
    /// Creates the notice, which is hidden until open() is called. The pages must outlive it.
    explicit MarchedNotice(PageTabs& pages, QWidget* parent = nullptr);

    /// Shows the notice `what` for this blow of a sequence, and remembers the blow for pages that can show
    /// it; see blowOf().
    void open(const MarchedQuestion& blow, const QString& what);
    /// Returns to the single blow from rest, and hides the notice. Must be called when the scenario changes.
    void forget();
    /// Returns the blow of a sequence that the page should show. Nothing if the page should show the single
    /// blow from rest, or can show no other.
    std::optional<MarchedQuestion> blowOf(const Page& page) const;

  signals:
    /// Emitted when the user asks to see the usual single blow from rest again, instead of one blow of a
    /// sequence.
    void singleWanted();

  private:
    void follow();

    PageTabs& m_pages;
    std::optional<MarchedQuestion> m_blow;
};

// Notice of which value was taken from a plot, with a button to undo it.

/// Notice that the user has taken a value from a plot into the scenario, with a button to undo this. It
/// disappears with the next change of the scenario.
class TakenNotice : public Notice {
    Q_OBJECT

  public:
    /// Creates the notice, which is hidden until a page reports a value. The document must outlive it, as
    /// must the pages passed to follow().
    explicit TakenNotice(Document& document, QWidget* parent = nullptr);
    /// Starts showing a notice whenever a page reports that a value was taken. Call it once, when all pages
    /// exist.
    void follow(PageTabs& pages);

  private:
    Document& m_document;
    int m_step = -1;  // index of the undo stack after the reported step
};

// Notice of why a page of waves shows a coarser string, with a button to round lengths so that it shows all
// waves.

/// Notice that the waves of a drill string are too many to be stored in full. It is shown only if rounding
/// the section lengths to 10 mm would change them, and offers to do so.
class WavesNotice : public Notice {
    Q_OBJECT

  public:
    /// Creates the notice, which is hidden at first, and when the scenario or the page changes. Document and
    /// pages must outlive it.
    WavesNotice(Document& document, PageTabs& pages, QWidget* parent = nullptr);

    void present(const SolvedBlow& blow);

  private:
    QString changesText(const DrillString& rounded) const;

    Document& m_document;
};

}  // namespace drillwave
