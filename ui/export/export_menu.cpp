// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_menu.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QKeyEvent>
#include <algorithm>

#include "core/archive/result_scenario.h"
#include "core/study/thrust/thrust_margins.h"
#include "ui/document/whole_file.h"
#include "ui/export/export_place.h"
#include "ui/export/numbers_window.h"
#include "ui/export/plot_export.h"
#include "ui/plot/plot_rendering.h"
#include "ui/text/language.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

QString csvFilter() {
    return ExportMenu::tr("CSV (*.csv);;All files (*)");
}

/// Of a line of the menu, as it stands elsewhere: "&Data of this plot…".
QString plainTitle(QString title) {
    return title.remove(u'&').remove(u'…').trimmed();
}

}  // namespace

ExportMenu::ExportMenu(Document& document, Questions& questions, Sources sources, QWidget* window)
    : QMenu(tr("&Export"), window),
      m_document(document),
      m_questions(questions),
      m_sources(std::move(sources)),
      m_window(window) {
    setToolTipsVisible(true);
    qApp->installEventFilter(this);
    m_histories = add(tr("&Histories…"), {}, {}, [this] { saveHistories(); });
    m_histories->setToolTip(tr("Forces, impulse, momentum, penetration and velocity over time, as CSV"));
    add(tr("&Events…"), {}, tr("Contacts, reversals and separations with their times, as CSV"),
        [this] { saveEvents(); });
    m_numbers = add(tr("&Numbers as a table"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_T),
                    tr("The numbers this page draws, in a window of their own, to read and copy"),
                    [this] { showNumbers(); });
    m_numbers->setObjectName(QStringLiteral("numbersAsTable"));
    addSeparator();
    m_afterPictures = add(tr("&Copy picture"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C),
                          tr("The present view, to paste into a report"), [this] { copyPicture(); });
    m_afterPictures->setObjectName(QStringLiteral("copyPicture"));
    addSeparator();
    add(tr("Everything into a &folder…"), QKeySequence(Qt::CTRL | Qt::Key_E),
        tr("Scenario, summary, histories, events and plots, as `drillwave run -o` writes them"),
        [this] { saveEverything(); });
}

QAction* ExportMenu::add(const QString& text, const QKeySequence& keys, const QString& toolTip,
                         const std::function<void()>& then, QAction* before) {
    auto* action = new QAction(text, this);
    action->setShortcut(keys);
    action->setToolTip(toolTip);
    connect(action, &QAction::triggered, this, then);
    insertAction(before, action);
    return action;
}

void ExportMenu::setExports(const QList<PageExport>& exports) {
    qDeleteAll(std::exchange(m_actions, {}));
    m_exports = exports;
    bool hasPicture = false;
    for (const PageExport& offered : exports) {
        const bool first = offered.picture && !std::exchange(hasPicture, true);
        m_actions.append(add(
            offered.title, first ? QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_P) : QKeySequence(),
            offered.toolTip, [this, offered] { save(offered); },
            offered.picture ? m_afterPictures : m_numbers));
    }
    m_afterPictures->setEnabled(hasPicture);
    m_numbers->setEnabled(
        std::ranges::any_of(m_exports, [](const PageExport& each) { return !each.picture; }));
}

void ExportMenu::save(const PageExport& wanted) {
    if (const QString why = wanted.obstacle ? wanted.obstacle() : QString(); !why.isEmpty()) return fail(why);
    if (wanted.picture) return savePicture(wanted);
    const auto contents = [wanted](const SolvedRun& run) {
        const EnglishTexts english;
        const std::string rows = wanted.csv().toStdString();
        return wanted.content == PageExport::Content::rows ? runHeader(run) + rows : rows;
    };
    saveFile(tr("Save the data of the plot"), wanted.fileStem + QStringLiteral(".csv"), contents);
}

void ExportMenu::showNumbers() {
    m_sources.whenSolved(tr("The table"), [this] {
        if (isUnsolved()) return;
        QList<std::pair<QString, QByteArray>> tables;
        QString why;
        for (const PageExport& offered : m_exports) {
            if (offered.picture) continue;
            const QString obstacle = offered.obstacle ? offered.obstacle() : QString();
            if (obstacle.isEmpty())
                tables.append({plainTitle(offered.title), offered.csv()});
            else if (why.isEmpty())
                why = obstacle;
        }
        if (tables.isEmpty()) return fail(why);
        auto* numbers = new NumbersWindow(tr("Numbers: %1").arg(m_document.displayName()), tables, m_window);
        numbers->setAttribute(Qt::WA_DeleteOnClose);
        numbers->show();
    });
}

bool ExportMenu::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride || !watched->isWidgetType()) return false;
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool ours = key->key() == Qt::Key_E && key->modifiers() == Qt::ControlModifier;
    if (!ours || static_cast<QWidget*>(watched)->window() != m_window) return false;
    event->ignore();
    return true;
}

void ExportMenu::saveHistories() {
    if (const SolvedBlowPtr blow = m_sources.blow(); blow && blow->isSolved() && !blow->impact.hasHistories())
        return fail(tr("This blow has too many waves to keep: there are no histories."));
    saveFile(tr("Export the histories"), QStringLiteral("_histories.csv"), historiesFile);
}

void ExportMenu::saveEvents() {
    saveFile(tr("Export the events"), QStringLiteral("_events.csv"), eventsFile);
}

// Where to is asked first: a question that pops up when the solver is done would be in the way.
void ExportMenu::saveFile(const QString& title, const QString& ending, const MakeFile& make) {
    if (isUnsolved()) return;
    const QString path = m_questions.fileToExport(m_window, title, suggestion(ending), csvFilter());
    if (path.isEmpty()) return;
    withRun(QFileInfo(path).fileName(), [this, path, make](const SolvedRun& run) {
        finish(path, writeWholeFile(path, QByteArray::fromStdString(make(run))));
    });
}

bool ExportMenu::isUnsolved() {
    const SolvedBlowPtr blow = m_sources.blow();
    if (!blow || blow->fault.isEmpty()) return false;
    fail(tr("The blow could not be solved: %1").arg(blow->fault));
    return true;
}

void ExportMenu::withRun(const QString& what, const UseRun& use) {
    m_sources.whenSolved(what, [this, use] {
        if (isUnsolved()) return;
        try {
            use(solvedRun());
        } catch (const ScenarioError& error) {
            fail(translated(error));
        }
    });
}

void ExportMenu::saveEverything() {
    if (isUnsolved()) return;
    const QString folder = m_questions.folderToExport(m_window, QFileInfo(suggestion({})).path());
    if (folder.isEmpty()) return;
    QStringList there;
    for (const std::string& name : runFilesThere(QFile::encodeName(folder).toStdString()))
        there << QString::fromStdString(name);
    if (!there.isEmpty() && !m_questions.confirm(m_window, tr("Overwrite the files in this folder?"),
                                                 QDir::toNativeSeparators(folder) + QStringLiteral("\n\n") +
                                                     there.join(QStringLiteral(", ")),
                                                 tr("Overwrite")))
        return;
    const auto existing = there.isEmpty() ? ExistingFiles::kept : ExistingFiles::replaced;
    withRun(QFileInfo(folder).fileName(),
            [=, this](const SolvedRun& run) { writeFolder(folder, run, existing); });
}

void ExportMenu::writeFolder(const QString& folder, SolvedRun run, ExistingFiles existing) {
    run.units = customaryUnits(run.blow.scenario);
    const WaitCursor wait;
    addThrustMargin(run.blow);
    const std::vector<std::string> formats(pictureFormats.begin(), pictureFormats.end());
    Pictures pictures = [&] {
        const EnglishTexts english;
        return run.blow.impact.hasHistories() ? drawBlowPlots(run.blow, formats) : Pictures();
    }();
    if (!pictures.problem.isEmpty()) return fail(pictures.problem);
    const FolderEnd end = writeWholeFolder(QFile::encodeName(folder).toStdString(),
                                           runFolder(run, std::move(pictures.files)), existing);
    finish(folder, translated(end.problem));
}

void ExportMenu::savePicture(const PageExport& wanted) {
    const PictureChoice before = rememberedPictureChoice(wanted.picture->aspectRatio());
    const std::optional<PictureChoice> choice = m_questions.picture(m_window, before);
    if (!choice) return;
    remember(*choice);
    const QString ending = QStringLiteral(".") + choice->format;
    const QString filter = choice->format.toUpper() + QStringLiteral(" (*") + ending + QLatin1Char(')');
    const QString path = m_questions.fileToExport(m_window, tr("Save the picture"),
                                                  suggestion(wanted.fileStem + ending), filter);
    if (path.isEmpty()) return;
    m_sources.whenSolved(QFileInfo(path).fileName(),
                         [this, path, wanted, choice] { writePicture(path, wanted, *choice); });
}

void ExportMenu::writePicture(const QString& path, const PageExport& wanted, const PictureChoice& choice) {
    const WaitCursor wait;
    const QString title = QString::fromStdString(m_document.scenario().title);
    const QByteArray bytes = wanted.picture->file(choice, title);
    if (bytes.isEmpty()) return fail(tr("%1: not written, the plot could not be drawn").arg(path));
    finish(path, writeWholeFile(path, bytes));
}

// The first one: what Ctrl+Shift+P saves.
void ExportMenu::copyPicture() {
    const auto first =
        std::ranges::find_if(m_exports, [](const auto& each) { return each.picture.has_value(); });
    if (first == m_exports.end()) return;
    m_sources.whenSolved(tr("The picture"), [this, copy = first->picture->copy] {
        copy();
        emit exported(tr("The picture is in the clipboard."));
    });
}

SolvedRun ExportMenu::solvedRun() const {
    const SolvedBlowPtr blow = m_sources.blow();
    return {.blow = *blow,
            .scenarioText = completeScenarioText(m_document.contents()),
            .units = blow->request.units == UnitSystem::dimensionless ? OutputUnits::dimensionless
                                                                      : OutputUnits::si};
}

QString ExportMenu::suggestion(const QString& ending) const {
    return exportSuggestion(m_document, ending);
}

void ExportMenu::finish(const QString& path, const QString& problem) {
    if (!problem.isEmpty()) return fail(problem);
    rememberExportFolder(path);
    emit exported(tr("Written: %1").arg(QDir::toNativeSeparators(path)));
}

void ExportMenu::fail(const QString& problem) {
    m_questions.tell(m_window, Questions::Tone::failure, tr("The export has failed."), problem);
}

}  // namespace drillwave
