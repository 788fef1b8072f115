// SPDX-License-Identifier: GPL-3.0-or-later
// Menu File: new, open, examples, save, recent files and quit, with the question about unsaved changes.
#pragma once

#include <QMenu>
#include <QObject>

#include "core/yaml/examples.h"
#include "ui/document/document.h"
#include "ui/document/file_watch.h"
#include "ui/questions/questions.h"

class QDropEvent;
class QWidget;

namespace drillwave {

// Files that are dropped onto the window.

/// Event filter that accepts files dropped anywhere onto a window. Without it, text fields would insert the
/// names of the files.
class FileDrop : public QObject {
    Q_OBJECT

  public:
    explicit FileDrop(QWidget* window);

  signals:
    /// Emitted with the paths of the dropped local files, at least one. It is emitted only when the
    /// drag-and-drop is finished, so that the program they come from does not wait.
    void dropped(const QStringList& paths);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool take(QDropEvent& event);

    QWidget* m_window;
};

class FileMenu : public QMenu {
    Q_OBJECT

  public:
    /// Creates the menu. `document`, `questions` (which asks the user in dialogs) and `watch` (of the
    /// document's file) must outlive it; `exports` becomes its submenu.
    FileMenu(Document& document, Questions& questions, FileWatch& watch, QMenu* exports, QWidget* window);

    /// Opens a scenario file, or the scenario of a result file. It replaces the present scenario without
    /// asking, even if it is unsaved. Returns true on success, else shows the reason.
    bool openFile(const QString& path);
    void openExample(const Example& example);
    /// Opens a file dropped onto the window: a scenario, a result, or the CSV file of a hammer force. Starts
    /// an import for any other table. Refuses several files at once.
    void take(const QStringList& paths);
    /// Returns true if the present scenario may be replaced or closed because it is unchanged, was saved, or
    /// the user discards it. Asks the user if necessary.
    bool mayDiscard();
    bool save();
    bool saveAs();

    /// Returns true if all files may be tables of samples, judged by their names and first lines. Result
    /// files of this program are no such tables.
    static bool areTables(const QStringList& paths);

  signals:
    void exampleOpened(const drillwave::Example& example);
    /// Emitted when the user asks to import a measured signal from the file `path`. If `path` is empty, the
    /// user has still to choose a file.
    void importRequested(const QString& path);

  private:
    void addFileActions(QMenu* exports);
    void addExamples();
    void addFigures(QMenu& menu);
    void addRecentFiles();
    void openRecent(const QString& path);
    void remember(const QString& path);
    void forget(const QString& path);
    void showRecentFiles();
    bool saveTo(const QString& path);
    /// Returns true if `problem` is empty; otherwise shows it with the title `what`.
    bool succeeded(const QString& what, const QString& problem);

    Document& m_document;
    Questions& m_questions;
    FileWatch& m_watch;
    QWidget* m_window;
    QMenu* m_recent = nullptr;
};

}  // namespace drillwave
