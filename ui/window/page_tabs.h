// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of the window, of which one is on show, and the row of tabs to choose it by.
#pragma once

#include <QList>
#include <QPointer>
#include <QScrollArea>
#include <QStackedWidget>

#include "ui/pages/page.h"

class QMenu;

namespace drillwave {

class StaleVeil;
class TabStrip;

/// Subject of a page, in the order of the tabs: the blow of the scenario, studies, or several
/// runs.
enum class PageGroup { thisBlow, studies, runs };

/// The pages one upon the other. The tabs are elsewhere in the window, over its whole width.
class PageTabs : public QStackedWidget {
    Q_OBJECT

  public:
    explicit PageTabs(QWidget* parent);

    /// Adds a page after the present ones of its group.
    void add(Page* page, PageGroup group);
    /// The one on show.
    Page& current() const;
    /// As wide as any page needs, and as high as the page on show at the available width.
    QSize minimumSizeHint() const override;
    /// Returns a page in the order of the tabs, from 0 to count() − 1.
    Page& page(int index) const;
    /// The row of tabs, for the window to place.
    TabStrip* strip() const { return m_strip; }
    /// To go from page to page by the keyboard.
    void addTo(QMenu& menu);
    /// Whether what all pages show answers the present input.
    void setCurrent(bool current);
    /// Makes only the pages that show such a scenario choosable. If the one on show is not among them, the
    /// last one on show for such a scenario replaces it.
    void follow(const Scenario& scenario);
    /// Whether a page can be chosen, of the scenario that is there.
    bool isOffered(int index) const;
    /// Veils what is shown.
    void setOutOfDate(bool outOfDate);
    /// Puts a page on show; if it cannot be chosen, reports where its answer is.
    void choose(int index);
    /// The page shown last in an earlier run of the program.
    void restoreChoice();
    void saveChoice() const;

  signals:
    /// The needs of the page on show have changed.
    void needsChanged();
    void exportRequested(const drillwave::PageExport& wanted);
    /// Other pages can be chosen than before.
    void offersChanged();
    /// A page that was on show or is wanted has its answer elsewhere.
    void absent(drillwave::Page* page);
    /// The user wants a page that only drill strings have, and the scenario is none.
    void stringWanted();

  private:
    struct Group {
        PageGroup group;
        int pages = 0;
    };
    int addTab(Page* page, PageGroup group);
    void offer(Page& page, const Scenario& scenario);
    Page* replacementFor(const Scenario& scenario) const;

    QList<Group> m_groups;  // that have pages, in the order of the tabs
    TabStrip* m_strip;
    StaleVeil* m_veil;
    QPointer<Page> m_left;  // was on show before one that shows the other form of scenario
};

// The room for the pages.

/// Scrolls a page that needs more room than the window has, so that all of it can be reached. A narrow window
/// scrolls it sideways too.
class PageScroll : public QScrollArea {
    Q_OBJECT

  public:
    static constexpr int leastWidth = 400;  ///< [px] below which the window does not go

    explicit PageScroll(PageTabs* pages, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    /// The width [px] at which no page scrolls sideways.
    int neededWidth() const;
};

}  // namespace drillwave
