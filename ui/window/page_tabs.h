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

/// Group of a page in the row of tabs: pages on the blow of the scenario, on studies, or on several runs.
enum class PageGroup { thisBlow, studies, runs };

/// Stack of the pages of the window, one of which is visible. The row of tabs is a separate widget over the
/// full width of the window.
class PageTabs : public QStackedWidget {
    Q_OBJECT

  public:
    explicit PageTabs(QWidget* parent);

    /// Adds a page after the existing ones of its group.
    void add(Page* page, PageGroup group);
    /// Returns the visible page.
    Page& current() const;
    /// Returns the smallest size of the pages. It is the width that the widest page needs, and the height
    /// that the visible page needs at the available width.
    QSize minimumSizeHint() const override;
    /// Returns the height that the visible page needs at this width [px].
    int heightForWidth(int width) const override;
    /// Returns a page by its index in the order of the tabs, from 0 to count() − 1.
    Page& page(int index) const;
    /// Returns the row of tabs, a separate widget that the window places in its own layout.
    TabStrip* strip() const { return m_strip; }
    /// Adds to `menu` the actions that show the next and the previous page.
    void addTo(QMenu& menu);
    /// Sets whether the pages show results of the present input. Results of an earlier input cannot be
    /// copied.
    void setCurrent(bool current);
    /// Enables only the tabs of pages that can show this scenario. If the visible page cannot show it,
    /// another page is shown. This is the page left at the last such change, if it can show the scenario,
    /// else the first page that can.
    void follow(const Scenario& scenario);
    /// Returns true if the user can choose the page with this index (from 0), because it can show the present
    /// scenario.
    bool isOffered(int index) const;
    /// Covers the pages with a translucent layer while their results belong to an earlier input.
    void setOutOfDate(bool outOfDate);
    /// Shows the page with this index. If the page does not apply to the scenario but another page has its
    /// answer, emits absent() instead.
    void choose(int index);
    /// Shows the page that was visible when the last session of the program ended.
    void restoreChoice();
    void saveChoice() const;

  signals:
    /// Emitted when the visible page needs other data from the solver, or needs another size.
    void needsChanged();
    void exportRequested(const drillwave::PageExport& wanted);
    /// Emitted when a page may have become available or unavailable, because the scenario has changed.
    void offersChanged();
    /// Emitted when the visible or requested page does not apply to the scenario and its elsewhere() names
    /// another page with the answer.
    void absent(drillwave::Page* page);
    /// Emitted when the user clicks the tab of a page for drill strings, but the scenario is a uniform rod.
    /// The window then converts it to a drill string, if possible.
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

/// Scroll area for the pages of the window. It scrolls a page that is larger than the window, in a narrow
/// window also sideways.
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
