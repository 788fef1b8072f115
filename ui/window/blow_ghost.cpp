// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/blow_ghost.h"

#include "ui/document/document.h"
#include "ui/form/scenario_panel.h"
#include "ui/window/page_tabs.h"

namespace drillwave {

BlowGhost::BlowGhost(Document& document, ScenarioPanel& panel, PageTabs& pages, const Shown& shown,
                     QObject* parent)
    : QObject(parent), m_pages(pages) {
    connect(&panel, &ScenarioPanel::dragStarted, this, [this, shown] { set(shown()); });
    connect(&panel, &ScenarioPanel::dragEnded, this, [this] { set(nullptr); });
    connect(&document, &Document::presetTaken, this, [this, shown] {
        set(shown());
        m_stay = Stay::overThisChange;
    });
    connect(&document, &Document::scenarioChanged, this, &BlowGhost::followChange);
}

void BlowGhost::set(const SolvedBlowPtr& before) {
    Page& page = m_pages.current();
    page.setGhost(before && page.shows(before->request.scenario) ? before : nullptr);
}

void BlowGhost::followChange() {
    if (m_stay == Stay::untilTheNextChange) set(nullptr);
    m_stay = m_stay == Stay::overThisChange ? Stay::untilTheNextChange : Stay::no;
}

}  // namespace drillwave
