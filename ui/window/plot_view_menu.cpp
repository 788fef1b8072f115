// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/plot_view_menu.h"

#include "ui/plot/plot_menu.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/settings.h"
#include "ui/window/page_tabs.h"

namespace drillwave {

PlotViewMenu::PlotViewMenu(PageTabs& pages, QWidget* window)
    : QMenu(tr("&Plot on show"), window),
      m_pages(pages),
      m_table(new QAction(tr("&Table below plots"), this)) {
    setObjectName(QStringLiteral("plotViewMenu"));
    m_table->setCheckable(true);
    m_table->setChecked(Settings().value(tableShownKey, true).toBool());
    m_table->setToolTip(tr("Reads what is in view, or at the cursors A and B"));
    connect(m_table, &QAction::toggled, this, [this, window](bool shown) {
        Settings().setValue(tableShownKey, shown);
        for (PlotWidget* each : window->findChildren<PlotWidget*>()) each->reader().setTableShown(shown);
    });
    connect(this, &QMenu::aboutToShow, this, &PlotViewMenu::fill);
    addAction(tr("No plot"))->setEnabled(false);  // an empty menu would not open
}

// That with the focus, else the first that can be seen.
PlotWidget* PlotViewMenu::plot() const {
    PlotWidget* first = nullptr;
    for (PlotWidget* each : m_pages.current().findChildren<PlotWidget*>()) {
        if (each->hasFocus()) return each;
        if (!first && !each->isHidden()) first = each;
    }
    return first;
}

void PlotViewMenu::fill() {
    PlotWidget* shown = plot();
    if (!shown) {
        clear();
        addAction(tr("No plot"))->setEnabled(false);
        return;
    }
    const QCPAxisRect* used = shown->view().activeRect();
    fillPlotMenu(*this, *shown, used ? used->center() : shown->rect().center());
}

}  // namespace drillwave
