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

// Reports why a page is not there for this scenario, and where its answer is.

/// Goes away with the next page on show, and when its page can be chosen again.
class ElsewhereNotice : public Notice {
    Q_OBJECT

  public:
    /// The pages must outlive it.
    explicit ElsewhereNotice(PageTabs& pages, QWidget* parent = nullptr);

  private:
    void tell(Page* page);

    QPushButton* m_show;  // there where the page leads to the answer
    QPointer<Page> m_page;
};

// Reports that pages show one of many blows under the feed, and leads back to the single one.

/// Keeps which blow that is until it is closed or forgotten; visible above the pages that show it.
class MarchedNotice : public Notice {
    Q_OBJECT

  public:
    /// The pages must outlive it.
    explicit MarchedNotice(PageTabs& pages, QWidget* parent = nullptr);

    /// Shows this blow; `what` describes it in words.
    void open(const MarchedQuestion& blow, const QString& what);
    /// The scenario is another one.
    void forget();
    /// The blow that a page should show instead of the single one.
    std::optional<MarchedQuestion> blowOf(const Page& page) const;

  signals:
    /// The user wants the single blow again.
    void singleWanted();

  private:
    void follow();

    PageTabs& m_pages;
    std::optional<MarchedQuestion> m_blow;
};

// Reports which value was taken from a plot, and takes it back.

/// Goes away with the next change of the scenario.
class TakenNotice : public Notice {
    Q_OBJECT

  public:
    /// Document and pages must outlive it.
    explicit TakenNotice(Document& document, QWidget* parent = nullptr);
    /// Listens to every page; once, when all pages are there.
    void follow(PageTabs& pages);

  private:
    Document& m_document;
    int m_step = -1;  // index of the undo stack after the step that is shown
};

// Reports why a page of waves is empty, and rounds lengths so that it is not.

/// Shown while the waves of the page were too many to be kept, where rounded lengths may help.
class WavesNotice : public Notice {
    Q_OBJECT

  public:
    /// Document and pages must outlive it.
    WavesNotice(Document& document, PageTabs& pages, QWidget* parent = nullptr);

    void present(const SolvedBlow& blow);

  private:
    QString changesText(const DrillString& rounded) const;

    Document& m_document;
};

}  // namespace drillwave
