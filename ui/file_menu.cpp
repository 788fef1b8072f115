#include "ui/file_menu.h"

#include <QDir>
#include <QFileInfo>

#include "core/file/examples.h"
#include "ui/settings.h"

namespace drillwave {
namespace {

constexpr int recentLimit = 10;
const QString recentKey = QStringLiteral("recentFiles");

QString fromUtf8(const std::string& text) {
    return QString::fromStdString(text);
}

}  // namespace

FileMenu::FileMenu(Document& document, Questions& questions, QWidget* window)
    : QMenu(tr("&File"), window), m_document(document), m_questions(questions), m_window(window) {
    setToolTipsVisible(true);
    addFileActions();
}

void FileMenu::addFileActions() {
    addAction(tr("&New"), QKeySequence::New, this, [this] {
        if (mayDiscard()) m_document.start();
    });
    addAction(tr("&Open…"), QKeySequence::Open, this, [this] {
        if (!mayDiscard()) return;
        const QString path = m_questions.fileToOpen(m_window, QFileInfo(m_document.path()).absolutePath());
        if (!path.isEmpty() && succeeded(tr("The scenario cannot be opened."), m_document.open(path)))
            remember(m_document.path());
    });
    addExamples();
    addRecentFiles();
    addSeparator();
    addAction(tr("&Save"), QKeySequence::Save, this, &FileMenu::save);
    // Without a desktop theme some standard shortcuts are empty.
    addAction(tr("Save &As…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), this, &FileMenu::saveAs);
    addSeparator();
    QAction* quit = addAction(tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q), m_window, &QWidget::close);
    quit->setMenuRole(QAction::QuitRole);
}

void FileMenu::addExamples() {
    QMenu* menu = addMenu(tr("&Examples"));
    menu->setToolTipsVisible(true);
    for (const Example& example : builtInExamples()) {
        QAction* action = menu->addAction(fromUtf8(example.title), this, [this, &example] {
            if (mayDiscard())
                succeeded(tr("The example cannot be opened."),
                          m_document.startFrom(example.text, fromUtf8(example.name)));
        });
        action->setToolTip(QStringLiteral("<p>%1</p>").arg(fromUtf8(example.explanation).toHtmlEscaped()));
    }
}

void FileMenu::addRecentFiles() {
    m_recent = addMenu(tr("Open &Recent"));
    showRecentFiles();
}

void FileMenu::showRecentFiles() {
    m_recent->clear();
    for (const QString& path : Settings().value(recentKey).toStringList())
        m_recent->addAction(QDir::toNativeSeparators(path), this, [this, path] {
            if (mayDiscard()) openFile(path);
        });
    m_recent->menuAction()->setVisible(!m_recent->isEmpty());
}

void FileMenu::remember(const QString& path) {
    Settings settings;
    QStringList paths = settings.value(recentKey).toStringList();
    paths.removeAll(path);
    paths.prepend(path);
    settings.setValue(recentKey, paths.mid(0, recentLimit));
    showRecentFiles();
}

bool FileMenu::openFile(const QString& path) {
    if (!succeeded(tr("The scenario cannot be opened."), m_document.open(path))) return false;
    remember(m_document.path());
    return true;
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
    return m_document.path().isEmpty() ? saveAs() : saveTo(m_document.path());
}

bool FileMenu::saveAs() {
    const QString suggestion =
        m_document.path().isEmpty() ? QStringLiteral("scenario.yaml") : m_document.path();
    const QString path = m_questions.fileToSave(m_window, suggestion);
    return !path.isEmpty() && saveTo(path);
}

bool FileMenu::saveTo(const QString& path) {
    if (!succeeded(tr("The scenario has not been saved."), m_document.save(path))) return false;
    remember(m_document.path());
    return true;
}

bool FileMenu::succeeded(const QString& what, const QString& problem) {
    if (!problem.isEmpty()) m_questions.tell(m_window, Questions::Tone::failure, what, problem);
    return problem.isEmpty();
}

}  // namespace drillwave
