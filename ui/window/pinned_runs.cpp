// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/pinned_runs.h"

#include <QAction>
#include <QDir>
#include <QFile>
#include <algorithm>
#include <iterator>
#include <utility>

#include "ui/pages/compare/compare_page.h"
#include "ui/result/result_panel.h"
#include "ui/text/shown_text.h"
#include "ui/window/page_tabs.h"

namespace drillwave {
namespace {

// Returns the runs that the page can lay over its own plot.
RunListPtr runsFor(const Page& page, const RunListPtr& all) {
    const auto fits = [&](const Run& run) { return page.shows(run.contents.scenario); };
    if (std::ranges::all_of(*all, fits)) return all;
    auto some = std::make_shared<RunList>();
    std::ranges::copy_if(*all, std::back_inserter(*some), fits);
    return some;
}

}  // namespace

PinnedRuns::PinnedRuns(Document& document, Questions& questions, QWidget* window)
    : QObject(window),
      m_document(document),
      m_questions(questions),
      m_window(window),
      m_runs(document.units()),
      m_solver(m_runs),
      m_keeper(document, m_runs),
      m_pinAction(new QAction(tr("&Pin this result"), this)),
      m_keepAction(new QAction(tr("&Keep runs beside the file"), this)),
      m_panel(new RunPanel(m_runs, window)) {
    m_pinAction->setIconText(tr("Pin"));
    m_pinAction->setToolTip(tr("Keep this result with its scenario, to compare others with (F7)"));
    m_pinAction->setShortcut(QKeySequence(Qt::Key_F7));
    m_keepAction->setCheckable(true);
    m_keepAction->setToolTip(tr(
        "In a folder of the same name, “.runs”: a scenario for each, so that they are there when the file is "
        "opened again"));
    connect(m_keepAction, &QAction::triggered, this, &PinnedRuns::keep);
    connect(&m_keeper, &RunKeeper::keptChanged, m_keepAction, &QAction::setChecked);
    connect(m_keepAction, &QAction::toggled, m_panel, &RunPanel::setKept);
    connect(&m_keeper, &RunKeeper::failed, this, &PinnedRuns::fail);
    // Once saving is over: others hear of it while the question is open.
    connect(&m_keeper, &RunKeeper::othersFound, this, [this](const QString& folder) {
        m_othersFolder = folder;
        QMetaObject::invokeMethod(this, &PinnedRuns::askAboutOthers, Qt::QueuedConnection);
    });
    connect(m_panel, &RunPanel::revertRequested, this, &PinnedRuns::revertTo);
}

void PinnedRuns::addTo(PageTabs& pages) {
    auto* compare = new ComparePage(m_runs, m_document.units());
    pages.add(compare, PageGroup::runs);
    connect(compare, &ComparePage::revertRequested, this, &PinnedRuns::revertTo);
    for (int index = 0; index < pages.count(); ++index) {
        Page& page = pages.page(index);
        connect(&m_runs, &Runs::changed, &page,
                [this, &page] { page.setRuns(runsFor(page, m_runs.list())); });
        connect(&page, &Page::pinRequested, this,
                [this](const ScenarioDocument& contents) { pin(contents, nullptr); });
        page.setRuns(runsFor(page, m_runs.list()));
    }
}

void PinnedRuns::follow(ResultPanel& result) {
    connect(&m_runs, &Runs::changed, &result, [this, &result] {
        const Run* reference = m_runs.reference();
        result.setReference(reference ? reference->blow : nullptr,
                            reference ? reference->title() : QString());
    });
}

void PinnedRuns::present(const SolvedBlowPtr& blow) {
    m_now = blow;
    m_panel->present(blow);
    if (blow->request.quick || !blow->fault.isEmpty()) return;
    // A copy: each blow makes a new list.
    for (const RunListPtr list = m_runs.list(); const Run& run : *list)
        if (!run.blow && run.contents.scenario == blow->request.scenario) m_runs.setBlow(run.number, blow);
}

bool PinnedRuns::isResultCurrent() const {
    return m_now && !m_now->request.quick && m_now->request.scenario == m_document.scenario();
}

void PinnedRuns::pin() {
    const bool isCurrent = isResultCurrent();
    if (isCurrent && !m_now->fault.isEmpty())
        return fail(tr("There is no result to be pinned."), m_now->fault);
    try {
        ScenarioDocument contents = m_document.contents();
        contents.text = m_document.text().toStdString();
        pin(std::move(contents), isCurrent ? m_now : nullptr);
    } catch (const ScenarioError& error) {
        fail(tr("This result cannot be pinned."), translated(error));
    }
}

void PinnedRuns::pin(ScenarioDocument contents, const SolvedBlowPtr& blow) {
    contents.source = QFile::encodeName(m_document.origin()).toStdString();
    const QString problem = m_runs.pin(std::move(contents), blow, m_document.displayName());
    if (!problem.isEmpty()) fail(tr("This result is not pinned."), problem);
}

void PinnedRuns::revertTo(int number) {
    const Run* run = m_runs.find(number);
    if (!run) return;
    const QString problem = m_document.useContents(run->contents, tr("revert to %1").arg(run->title()));
    if (!problem.isEmpty()) fail(tr("The run cannot be brought back."), problem);
}

void PinnedRuns::keep(bool wanted) {
    const QString folder = QDir::toNativeSeparators(m_keeper.folder());
    if (!wanted) {
        if (m_questions.confirm(m_window, tr("Delete the kept runs?"),
                                tr("%1\nThey stay on the list until the window is closed.").arg(folder),
                                tr("Delete")))
            m_keeper.giveUp();
    } else if (const bool hasOthers = m_keeper.holdsOthers();
               !hasOthers ||
               m_questions.confirm(m_window, tr("There are runs beside this file already."),
                                   tr("%1\nRuns that are not on the list here would be lost.").arg(folder),
                                   tr("Replace"))) {
        const auto existing = hasOthers ? ExistingFiles::replaced : ExistingFiles::kept;
        if (const QString problem = m_keeper.keep(existing); !problem.isEmpty())
            fail(tr("The runs are not kept."), problem);
    }
    m_keepAction->setChecked(m_keeper.isKept());
}

// Another file may have been opened meanwhile.
void PinnedRuns::askAboutOthers() {
    const QString folder = std::exchange(m_othersFolder, QString());
    if (!folder.isEmpty() && folder == m_keeper.folder() && !m_keeper.isKept()) keep(true);
}

bool PinnedRuns::mayClose() {
    askAboutOthers();
    const QString problem = m_keeper.finish();
    return problem.isEmpty() || m_questions.confirmClose(m_window, tr("The runs are not kept."), problem);
}

void PinnedRuns::fail(const QString& what, const QString& problem) {
    m_questions.tell(m_window, Questions::Tone::failure, what, problem);
}

}  // namespace drillwave
