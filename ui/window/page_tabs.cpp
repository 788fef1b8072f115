// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/page_tabs.h"

#include <QLayout>
#include <QMenu>
#include <QScrollBar>
#include <algorithm>

#include "ui/result/stale_veil.h"
#include "ui/text/settings.h"
#include "ui/window/tab_strip.h"

namespace drillwave {

namespace {

const QString pageKey = QStringLiteral("window/page");
// Name of the page Curve in earlier versions.
const QString formerCurve = QStringLiteral("drillwave::StiffnessPage");

// Returns the name under which settings keep a page, in any language.
QString nameOf(const Page& page) {
    return QLatin1String(page.metaObject()->className());
}

QString caption(PageGroup group) {
    switch (group) {
        case PageGroup::thisBlow:
            return PageTabs::tr("THIS BLOW");
        case PageGroup::studies:
            return PageTabs::tr("STUDIES");
        case PageGroup::runs:
            break;
    }
    return {};  // a line is enough
}

constexpr int leastLines = 10;  // of text: what is lower is of no use

}  // namespace

PageTabs::PageTabs(QWidget* parent)
    : QStackedWidget(parent), m_strip(new TabStrip(this)), m_veil(new StaleVeil(this)) {
    connect(m_strip, &QTabBar::currentChanged, this, [this](int tab) {
        if (QWidget* page = m_strip->pageAt(tab)) setCurrentWidget(page);
    });
    connect(m_strip, &TabStrip::refused, this, &PageTabs::stringWanted);
    connect(this, &QStackedWidget::currentChanged, m_strip, [this] {
        m_strip->setCurrentIndex(m_strip->indexOf(currentWidget()));
        updateGeometry();  // the room that it needs is another one
    });
}

void PageTabs::add(Page* page, PageGroup group) {
    insertWidget(addTab(page, group), page);
    m_strip->setCurrentIndex(m_strip->indexOf(currentWidget()));
    connect(page, &Page::exportRequested, this, &PageTabs::exportRequested);
    connect(page, &Page::titleChanged, this,
            [this, page] { m_strip->rename(m_strip->indexOf(page), page->title()); });
    connect(page, &Page::needsChanged, this, [this, page] {
        if (page == currentWidget()) emit needsChanged();
    });
}

// Returns how many pages are before it.
int PageTabs::addTab(Page* page, PageGroup group) {
    auto found = std::ranges::find_if(m_groups, [=](const Group& each) { return each.group >= group; });
    int before = 0;
    for (auto each = m_groups.begin(); each != found; ++each) before += each->pages;
    const int tab = before + int(found - m_groups.begin());  // each group has a caption
    if (found == m_groups.end() || found->group != group) {
        found = m_groups.insert(found, {group});
        m_strip->insertCaption(tab, caption(group));
    }
    m_strip->insertPage(tab + 1 + found->pages, page, page->title());
    return before + found->pages++;
}

Page& PageTabs::current() const {
    return page(currentIndex());
}

QSize PageTabs::minimumSizeHint() const {
    const int widest = layout()->minimumSize().width();
    // The width of the parent, which the tabs are about to have.
    return {widest, heightForWidth(std::max(widest, parentWidget() ? parentWidget()->width() : width()))};
}

// The stack alone would take the height of its highest page, and scroll a page that fits.
int PageTabs::heightForWidth(int width) const {
    const QLayout* parts = count() > 0 ? current().layout() : nullptr;
    if (!parts) return QStackedWidget::minimumSizeHint().height();
    return parts->hasHeightForWidth() ? parts->minimumHeightForWidth(width)
                                      : current().minimumSizeHint().height();
}

Page& PageTabs::page(int index) const {
    return *static_cast<Page*>(widget(index));
}

void PageTabs::addTo(QMenu& menu) {
    menu.addAction(tr("&Next page"), QKeySequence(Qt::CTRL | Qt::Key_Tab), this,
                   [this] { m_strip->choose(1); });
    menu.addAction(tr("&Previous page"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Tab), this,
                   [this] { m_strip->choose(-1); });
}

void PageTabs::setCurrent(bool current) {
    for (int index = 0; index < count(); ++index) page(index).setCurrent(current);
}

void PageTabs::follow(const Scenario& scenario) {
    Page* gone = nullptr;
    if (!current().shows(scenario)) {
        Page* next = replacementFor(scenario);
        m_left = gone = &current();
        m_strip->setTabEnabled(m_strip->indexOf(next), true);
        setCurrentWidget(next);
    }
    for (int index = 0; index < count(); ++index) offer(page(index), scenario);
    emit offersChanged();
    if (gone && !gone->elsewhere().isEmpty()) emit absent(gone);
}

Page* PageTabs::replacementFor(const Scenario& scenario) const {
    if (m_left && m_left->shows(scenario)) return m_left;
    for (int index = 0; index < count(); ++index)
        if (page(index).shows(scenario)) return &page(index);
    return &current();
}

void PageTabs::offer(Page& page, const Scenario& scenario) {
    m_strip->setOffered(m_strip->indexOf(&page), page.shows(scenario),
                        page.elsewhere().isEmpty()
                            ? tr("only for drill strings, and this scenario is a uniform rod: a click "
                                 "converts it, as Edit ▸ Make a drill string of this does")
                            : QString());
}

bool PageTabs::isOffered(int index) const {
    return m_strip->isTabEnabled(m_strip->indexOf(widget(index)));
}

void PageTabs::choose(int index) {
    if (isOffered(index)) return setCurrentIndex(index);
    if (!page(index).elsewhere().isEmpty()) emit absent(&page(index));
}

void PageTabs::setOutOfDate(bool outOfDate) {
    m_veil->raise();
    m_veil->setVisible(outOfDate);
}

void PageTabs::restoreChoice() {
    QString kept = Settings().value(pageKey).toString();
    if (kept == formerCurve) kept = QStringLiteral("drillwave::CurvePage");
    for (int index = 0; index < count(); ++index)
        if (nameOf(page(index)) == kept) choose(index);
}

void PageTabs::saveChoice() const {
    Settings().setValue(pageKey, nameOf(current()));
}

PageScroll::PageScroll(PageTabs* pages, QWidget* parent) : QScrollArea(parent) {
    setObjectName(QStringLiteral("pageScroll"));
    setWidget(pages);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
}

QSize PageScroll::sizeHint() const {
    return widget()->sizeHint();
}

QSize PageScroll::minimumSizeHint() const {
    return {std::min(neededWidth(), leastWidth), leastLines * fontMetrics().height()};
}

int PageScroll::neededWidth() const {
    return widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width();
}

}  // namespace drillwave
