// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/file_menu.h"

#include <QApplication>
#include <QDir>
#include <QDropEvent>
#include <QFileInfo>
#include <QMimeData>
#include <QTimer>
#include <QUrl>
#include <QWidget>
#include <algorithm>

#include "core/archive/result_scenario.h"
#include "core/study/paper/figures.h"
#include "ui/text/settings.h"
#include "ui/text/shown_text.h"
#include "ui/window/figure_dialog.h"

namespace drillwave {

namespace {

QStringList localFiles(const QMimeData* data) {
    QStringList paths;
    for (const QUrl& url : data->urls())
        if (url.isLocalFile()) paths.append(url.toLocalFile());
    return paths;
}

constexpr int recentLimit = 10;

// The groups that a scenario has by default.
constexpr std::string_view dimensionlessStart =
    "drillwave: 1\n"
    "dimensionless: {beta: 0.5, gamma: 1, tau: 10, delta: 0}\n"
    "pulse: {shape: rectangular}\n";

bool isScenarioName(const QString& path) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    return QStringList{QStringLiteral("yaml"), QStringLiteral("yml"), QStringLiteral("json")}.contains(
        suffix);
}

bool isCsv(const QString& path) {
    return isCsvName(path.toStdString());
}

// Tables of samples that no command writes: only importing finds out what they hold.
bool isTableName(const QString& path) {
    static const QStringList suffixes{QStringLiteral("txt"), QStringLiteral("tsv"), QStringLiteral("dat"),
                                      QStringLiteral("asc"), QStringLiteral("prn")};
    return suffixes.contains(QFileInfo(path).suffix().toLower());
}

bool isPage(const QString& path) {
    return QFileInfo(path).suffix().compare(QStringLiteral("html"), Qt::CaseInsensitive) == 0;
}

// Results begin with the lines of their scenario; a table of times and forces begins with its header.
bool isResult(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) && file.read(1) == "#";
}

}  // namespace

FileDrop::FileDrop(QWidget* window) : QObject(window), m_window(window) {
    window->setAcceptDrops(true);
    qApp->installEventFilter(this);
}

bool FileDrop::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::DragEnter:
        case QEvent::DragMove:
        case QEvent::Drop:
            break;
        default:
            return false;
    }
    const bool isOurs = watched->isWidgetType() && static_cast<QWidget*>(watched)->window() == m_window;
    return isOurs && take(static_cast<QDropEvent&>(*event));
}

bool FileDrop::take(QDropEvent& event) {
    const QStringList paths = localFiles(event.mimeData());
    if (paths.isEmpty()) return false;
    event.setDropAction(Qt::CopyAction);
    event.accept();
    if (event.type() == QEvent::Drop) QTimer::singleShot(0, this, [this, paths] { emit dropped(paths); });
    return true;
}

FileMenu::FileMenu(Document& document, Questions& questions, FileWatch& watch, QMenu* exports,
                   QWidget* window)
    : QMenu(tr("&File"), window),
      m_document(document),
      m_questions(questions),
      m_watch(watch),
      m_window(window) {
    setToolTipsVisible(true);
    addFileActions(exports);
}

void FileMenu::addFileActions(QMenu* exports) {
    addAction(tr("&New"), QKeySequence::New, this, [this] {
        if (mayDiscard()) m_document.start();
    });
    QAction* groups =
        addAction(tr("New di&mensionless"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_N), this, [this] {
            if (mayDiscard()) m_document.startFrom(dimensionlessStart, tr("new"));
        });
    groups->setToolTip(tr("A scenario given only by its groups β, γ, τ and δ, without units"));
    addAction(tr("&Open…"), QKeySequence::Open, this, [this] {
        const QString folder = QFileInfo(m_document.suggestedPath()).absolutePath();
        const QString path = m_questions.fileToOpen(m_window, folder);
        if (!path.isEmpty() && mayDiscard()) openFile(path);
    });
    addExamples();
    addRecentFiles();
    addSeparator();
    addAction(tr("&Save"), QKeySequence::Save, this, &FileMenu::save);
    // Without a desktop theme some standard shortcuts are empty.
    addAction(tr("Save &As…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), this, &FileMenu::saveAs);
    QAction* import = addAction(tr("&Import…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_I), this,
                                [this] { emit importRequested({}); });
    import->setToolTip(
        tr("A measured signal from a table of samples: as the hammer blow, or to compare with"));
    addMenu(exports);
    addSeparator();
    QAction* quit = addAction(tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q), m_window, &QWidget::close);
    quit->setMenuRole(QAction::QuitRole);
}

void FileMenu::addExamples() {
    QMenu* menu = addMenu(tr("&Examples"));
    menu->setToolTipsVisible(true);
    for (const Example& example : builtInExamples()) {
        QAction* action =
            menu->addAction(coreText(example.title), this, [this, &example] { openExample(example); });
        action->setToolTip(QStringLiteral("<p>%1</p>").arg(coreText(example.explanation).toHtmlEscaped()));
    }
    menu->addSeparator();
    addFigures(*menu->addMenu(tr("&Figures of the paper")));
}

// Opens figures next to the window, whose scenario stays.
void FileMenu::addFigures(QMenu& menu) {
    menu.setToolTipsVisible(true);
    const QStringList contents{
        tr("waves at the middle of the rod"),   tr("impact force, impulse and momentum"),
        tr("impact force and its closed form"), tr("restitution over the stiffness"),
        tr("restitution and its closed form"),  tr("restitution over the gap")};
    for (int number = firstPaperFigure; number <= lastPaperFigure; ++number) {
        QAction* action = menu.addAction(
            tr("Figure &%1: %2").arg(number).arg(contents[number - firstPaperFigure]), this, [this, number] {
                auto* dialog = new FigureDialog(number, m_window);
                dialog->setAttribute(Qt::WA_DeleteOnClose);
                dialog->show();
            });
        action->setToolTip(tr("Computed again, beside the numbers that the paper prints"));
    }
}

void FileMenu::openExample(const Example& example) {
    if (!mayDiscard()) return;
    const QString problem = m_document.startFrom(example.text, QString::fromStdString(example.name));
    if (succeeded(tr("The example cannot be opened."), problem)) emit exampleOpened(example);
}

void FileMenu::addRecentFiles() {
    m_recent = addMenu(tr("Open &Recent"));
    showRecentFiles();
}

void FileMenu::showRecentFiles() {
    m_recent->clear();
    const QStringList paths = Settings().value(recentFilesKey).toStringList();
    for (const QString& path : paths) {
        // An ampersand in the name is no mnemonic.
        const QString name = QDir::toNativeSeparators(path).replace(QLatin1Char('&'), QLatin1String("&&"));
        m_recent->addAction(name, this, [this, path] { openRecent(path); });
    }
    m_recent->addSeparator();
    QAction* clear = m_recent->addAction(tr("&Clear list"), this, [this] {
        Settings().remove(recentFilesKey);
        showRecentFiles();
    });
    clear->setToolTip(tr("Clears this list; the files stay"));
    m_recent->menuAction()->setVisible(!paths.isEmpty());
}

void FileMenu::openRecent(const QString& path) {
    if (QFileInfo::exists(path)) {
        if (mayDiscard()) openFile(path);
        return;
    }
    if (m_questions.confirm(m_window, tr("This file is no longer there."),
                            tr("%1\nIt may be on a drive that is not connected. Remove it from the list?")
                                .arg(QDir::toNativeSeparators(path)),
                            tr("Remove")))
        forget(path);
}

void FileMenu::remember(const QString& path) {
    Settings settings;
    QStringList paths = settings.value(recentFilesKey).toStringList();
    paths.removeAll(path);
    paths.prepend(path);
    settings.setValue(recentFilesKey, paths.mid(0, recentLimit));
    showRecentFiles();
}

void FileMenu::forget(const QString& path) {
    Settings settings;
    QStringList paths = settings.value(recentFilesKey).toStringList();
    paths.removeAll(path);
    settings.setValue(recentFilesKey, paths);
    showRecentFiles();
}

bool FileMenu::openFile(const QString& path) {
    if (!succeeded(tr("The scenario cannot be opened."), m_document.open(path))) return false;
    remember(QFileInfo(path).absoluteFilePath());
    return true;
}

bool FileMenu::areTables(const QStringList& paths) {
    return std::ranges::all_of(
        paths, [](const QString& path) { return isTableName(path) || (isCsv(path) && !isResult(path)); });
}

void FileMenu::take(const QStringList& paths) {
    const QString refusal = tr("This cannot be opened.");
    if (paths.size() > 1) {
        succeeded(refusal, tr("%1 files were dropped; drop one at a time.").arg(paths.size()));
    } else if (isScenarioName(paths.first()) || isPage(paths.first()) ||
               (isCsv(paths.first()) && isResult(paths.first()))) {
        if (mayDiscard()) openFile(paths.first());
    } else if (isCsv(paths.first())) {
        // A file that is no table of a blow as it is may become one by an import.
        if (!m_document.useTable(paths.first()).isEmpty()) emit importRequested(paths.first());
    } else if (isTableName(paths.first())) {
        emit importRequested(paths.first());
    } else {
        succeeded(refusal, tr("%1\nDrop a scenario (.yaml), a file of a run (.csv, .json), a report (.html), "
                              "the CSV file of a hammer blow, or a table of samples (.txt, .dat).")
                               .arg(QDir::toNativeSeparators(paths.first())));
    }
}

bool FileMenu::mayDiscard() {
    if (!m_document.isModified()) return true;
    switch (m_questions.unsavedChanges(m_window, m_document.displayName())) {
        case Questions::Unsaved::save:
            return save();
        case Questions::Unsaved::discard:
            return true;
        case Questions::Unsaved::cancel:
            return false;
    }
    return false;
}

bool FileMenu::save() {
    const QString path = m_document.path();
    if (path.isEmpty()) return saveAs();
    if (m_watch.savingNeedsConsent() &&
        !m_questions.confirm(
            m_window, tr("The file has been changed by another program."),
            tr("%1\nSaving overwrites the changes of that program.").arg(QDir::toNativeSeparators(path)),
            tr("Overwrite")))
        return false;
    return saveTo(path);
}

bool FileMenu::saveAs() {
    QString path = m_questions.fileToSave(m_window, m_document.suggestedPath());
    if (path.isEmpty()) return false;
    if (isScenarioName(path)) return saveTo(path);
    // The dialog has asked about the name as given.
    path += QStringLiteral(".yaml");
    if (QFileInfo::exists(path) && !m_questions.confirm(m_window, tr("A file of this name exists already."),
                                                        QDir::toNativeSeparators(path), tr("Overwrite")))
        return false;
    return saveTo(path);
}

bool FileMenu::saveTo(const QString& path) {
    if (!succeeded(tr("The scenario has not been saved."), m_document.save(path))) return false;
    m_watch.check();
    remember(m_document.path());
    return true;
}

bool FileMenu::succeeded(const QString& what, const QString& problem) {
    if (!problem.isEmpty()) m_questions.tell(m_window, Questions::Tone::failure, what, problem);
    return problem.isEmpty();
}

}  // namespace drillwave
