// SPDX-License-Identifier: GPL-3.0-or-later
// Pages of the window, one of which is visible, and the row of tabs for choosing it.
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

/// Group of a page in the row of tabs: the blow of the scenario, studies, or several runs.
enum class PageGroup { thisBlow, studies, runs };

/// Stack of pages. The row of tabs is a separate widget over the full width of the window.
class PageTabs : public QStackedWidget {
    Q_OBJECT

  public:
    explicit PageTabs(QWidget* parent);

    /// Adds a page after the existing ones of its group.
    void add(Page* page, PageGroup group);
    /// Returns the visible page.
    Page& current() const;
    /// Returns the width that the widest page needs, and the height that the visible page needs at the
    /// available width.
    QSize minimumSizeHint() const override;
    /// Returns the minimum height of the current page.
    int heightForWidth(int width) const override;
    /// Returns a page by its index in the order of the tabs, from 0 to count() − 1.
    Page& page(int index) const;
    /// Returns the row of tabs, which the window lays out.
    TabStrip* strip() const { return m_strip; }
    /// Adds actions that go to the next and the previous page to a menu.
    void addTo(QMenu& menu);
    /// Sets whether the pages show the answer to the present input.
    void setCurrent(bool current);
    /// Enables only the tabs of pages that can show this scenario. If the visible page cannot, it is replaced
    /// by the last visible one that can.
    void follow(const Scenario& scenario);
    /// Returns true if a page can be chosen for the present scenario.
    bool isOffered(int index) const;
    /// Covers the pages with a translucent layer while their results are out of date.
    void setOutOfDate(bool outOfDate);
    /// Shows a page; if it cannot be chosen, emits absent() instead.
    void choose(int index);
    /// Shows the page that was visible at the end of the last session.
    void restoreChoice();
    void saveChoice() const;

  signals:
    /// Emitted when the visible page needs other data or another size.
    void needsChanged();
    void exportRequested(const drillwave::PageExport& wanted);
    /// Emitted when the set of pages that can be chosen has changed.
    void offersChanged();
    /// Emitted when a page that is visible or requested does not apply to the scenario, and another page has
    /// its answer.
    void absent(drillwave::Page* page);
    /// Emitted when the user asks for a page for drill strings, but the scenario is a uniform rod.
    void stringWanted();

  private:
    struct Group {
        PageGroup group;
        int pages = 0;
    };
    int addTab(Page* page, PageGroup group);
    void offer(Page& page, const Scenario& scenario);
    Page* replacementFor(const Scenario& scenario) const;

    QList<Group> m_groups;  // groups that have pages, in the order of the tabs
    TabStrip* m_strip;
    StaleVeil* m_veil;
    // Page that was visible before the scenario changed to a form that it cannot show.
    QPointer<Page> m_left;
};

// Scroll area for the pages.

/// Scroll area that scrolls a page larger than the window, in a narrow window also sideways.
class PageScroll : public QScrollArea {
    Q_OBJECT

  public:
    static constexpr int leastWidth = 400;  ///< smallest width of the scroll area [px]

    explicit PageScroll(PageTabs* pages, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    /// Returns the width from which no page needs to scroll sideways [px].
    int neededWidth() const;
};

}  // namespace drillwave
