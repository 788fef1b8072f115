// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/page_tabs.h"

#include <QStackedWidget>

#include "ui/result/stale_veil.h"
#include "ui/text/settings.h"

namespace drillwave {
namespace {

const QString pageKey = QStringLiteral("window/page");

// What is kept of a page from one run to the next, in any language.
QString nameOf(const Page& page) {
    return QLatin1String(page.metaObject()->className());
}

}  // namespace

PageTabs::PageTabs(QWidget* parent)
    : QTabWidget(parent), m_veil(new StaleVeil(findChild<QStackedWidget*>())) {
    setDocumentMode(true);
    setTabBarAutoHide(true);
}

void PageTabs::add(Page* page) {
    m_pages.append(page);
    addTab(page, page->title());
    connect(page, &Page::exportRequested, this, &PageTabs::exportRequested);
    connect(page, &Page::needsChanged, this, [this, page] {
        if (page == currentWidget()) emit needsChanged();
    });
}

Page& PageTabs::current() const {
    return *m_pages.at(currentIndex());
}

void PageTabs::setCurrent(bool current) {
    for (Page* page : std::as_const(m_pages)) page->setCurrent(current);
}

void PageTabs::setOutOfDate(bool outOfDate) {
    m_veil->raise();
    m_veil->setVisible(outOfDate);
}

void PageTabs::restoreChoice() {
    const QString kept = Settings().value(pageKey).toString();
    for (Page* page : std::as_const(m_pages))
        if (nameOf(*page) == kept) setCurrentWidget(page);
}

void PageTabs::saveChoice() const {
    Settings().setValue(pageKey, nameOf(current()));
}

}  // namespace drillwave
