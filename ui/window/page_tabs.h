// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of the window as tabs, of which one is on show.
#pragma once

#include <QTabWidget>

#include "ui/pages/page.h"

namespace drillwave {

class StaleVeil;

class PageTabs : public QTabWidget {
    Q_OBJECT

  public:
    explicit PageTabs(QWidget* parent);

    void add(Page* page);
    Page& current() const;
    /// Whether what all pages show answers the present input.
    void setCurrent(bool current);
    /// Veils what is shown.
    void setOutOfDate(bool outOfDate);
    /// The page shown last in an earlier run of the program.
    void restoreChoice();
    void saveChoice() const;

  signals:
    /// Of the page on show.
    void needsChanged();
    void exportRequested(const drillwave::PageExport& wanted);

  private:
    QList<Page*> m_pages;
    StaleVeil* m_veil;
};

}  // namespace drillwave
