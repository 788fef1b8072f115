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

/// Event filter that accepts files dropped anywhere onto a window, also onto fields, which would insert their
/// names.
class FileDrop : public QObject {
    Q_OBJECT

  public:
    explicit FileDrop(QWidget* window);

  signals:
    /// Emitted with the paths of the dropped local files, at least one, after the drop has ended for the
    /// other program.
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
    /// Makes the menu. Document, questions and watch must outlive it; `exports` becomes its submenu.
    FileMenu(Document& document, Questions& questions, FileWatch& watch, QMenu* exports, QWidget* window);

    /// Opens a scenario file, or the scenario of a result, even if the present one is unsaved. Returns true
    /// on success, else shows the reason.
    bool openFile(const QString& path);
    void openExample(const Example& example);
    /// Opens a file dropped onto the window: a scenario, a result, or the CSV file of a hammer force. Starts
    /// an import for any other table.
    void take(const QStringList& paths);
    /// Returns true if the present scenario may be replaced or closed because it is unchanged, was saved, or
    /// the user discards it. Asks the user if necessary.
    bool mayDiscard();
    bool save();
    bool saveAs();

    /// Returns true if all files may be tables of samples, by their names and first lines.
    static bool areTables(const QStringList& paths);

  signals:
    void exampleOpened(const drillwave::Example& example);
    /// Emitted when the user asks to import a measured signal from the file `path`; empty if it is still to
    /// be chosen.
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
