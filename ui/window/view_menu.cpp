// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/view_menu.h"

#include <QActionGroup>

#include "ui/plot/plot_menu.h"
#include "ui/plot/plot_widget.h"
#include "ui/questions/questions.h"
#include "ui/text/language.h"
#include "ui/text/settings.h"
#include "ui/text/shown_text.h"
#include "ui/window/document_notices.h"
#include "ui/window/page_tabs.h"
#include "ui/window/units_choice.h"
#include "ui/window/window_layout.h"

namespace drillwave {

LanguageMenu::LanguageMenu(Questions& questions, QWidget* window)
    : QMenu(tr("&Language"), window),
      m_questions(questions),
      m_window(window),
      m_group(new QActionGroup(this)) {
    setObjectName(QStringLiteral("language"));
    add(tr("&System"), nullptr);
    addSeparator();
    for (const Language& language : languages) add(fromView(language.name), &language);
}

void LanguageMenu::add(const QString& text, const Language* language) {
    QAction* action = m_group->addAction(text);
    action->setCheckable(true);
    action->setChecked(language == chosenLanguage());
    connect(action, &QAction::triggered, this, [this, language] { choose(language); });
    addAction(action);
}

void LanguageMenu::choose(const Language* language) {
    if (language == chosenLanguage()) return;
    chooseLanguage(language);
    const QString name = fromView(languageToSpeak().name);
    if (m_questions.restartNow(
            m_window, tr("Restart Drillwave in this language now: %1?").arg(name),
            tr("Unsaved changes, the file name, pinned runs and measured signals come back. Numbers stay as "
               "the "
               "system writes them; files and some chapters of the manual are in English.")))
        emit restartWanted();
}

PlotViewMenu::PlotViewMenu(PageTabs& pages, QWidget* window)
    : QMenu(tr("&Plot on show"), window),
      m_pages(pages),
      m_table(new QAction(tr("&Table below plots"), this)) {
    setObjectName(QStringLiteral("plotViewMenu"));
    m_table->setCheckable(true);
    m_table->setChecked(Settings().value(tableShownKey, true).toBool());
    m_table->setToolTip(tr("Readings in view, or at the cursors A and B"));
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
