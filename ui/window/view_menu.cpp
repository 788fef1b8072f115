// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/view_menu.h"

#include "ui/window/area_keys.h"
#include "ui/window/example_note.h"
#include "ui/window/language_menu.h"
#include "ui/window/page_tabs.h"
#include "ui/window/plot_view_menu.h"
#include "ui/window/units_choice.h"
#include "ui/window/window_layout.h"

namespace drillwave {

ViewMenu::ViewMenu(const Parts& parts, QWidget* window) : QMenu(tr("&View"), window) {
    addMenu(&parts.units);
    addSeparator();
    addAction(tr("&Fit plots"), QKeySequence(Qt::CTRL | Qt::Key_0), this,
              [&pages = parts.pages] { pages.current().fit(); });
    auto* plot = new PlotViewMenu(parts.pages, window);
    addMenu(plot);
    addAction(plot->tableAction());
    addSeparator();
    parts.pages.addTo(*this);
    parts.areas.addTo(*this);
    addSeparator();
    parts.layout.addTo(*this);
    addSeparator();
    addAction(parts.example.action());
    addSeparator();
    auto* language = new LanguageMenu(parts.questions, window);
    connect(language, &LanguageMenu::restartWanted, this, &ViewMenu::restartWanted);
    addMenu(language);
}

}  // namespace drillwave
