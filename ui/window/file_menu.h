// SPDX-License-Identifier: GPL-3.0-or-later
// The File menu: new, open, examples, save, recent files, quit, with the question about unsaved changes.
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

// Files dropped onto the window.

/// Takes files dropped anywhere onto a window, also onto fields that would take their names as text.
class FileDrop : public QObject {
    Q_OBJECT

  public:
    explicit FileDrop(QWidget* window);

  signals:
    /// Paths of local files, at least one; sent after the drop has ended for the program they come from.
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
    /// Document, questions and watch must outlive the menu. `exports` becomes a part of it.
    FileMenu(Document& document, Questions& questions, FileWatch& watch, QMenu* exports, QWidget* window);

    /// Opens a scenario file, or the scenario of a result, instead of the present one, unsaved or not;
    /// reports why if it cannot. True when opened.
    bool openFile(const QString& path);
    void openExample(const Example& example);
    /// Takes what was dropped onto the window: a scenario, the CSV file of a result, or that of a hammer
    /// blow; asks for an import of any other table.
    void take(const QStringList& paths);
    /// Whether the present scenario may be replaced or closed: saved, unchanged or given up.
    bool mayDiscard();
    bool save();
    bool saveAs();

    /// Whether all files may be tables of samples.
    static bool areTables(const QStringList& paths);

  signals:
    void exampleOpened(const drillwave::Example& example);
    /// The user wants to import a measured signal: from that file, or from one to be chosen.
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
    /// Whether there is no problem; reports one.
    bool succeeded(const QString& what, const QString& problem);

    Document& m_document;
    Questions& m_questions;
    FileWatch& m_watch;
    QWidget* m_window;
    QMenu* m_recent = nullptr;
};

}  // namespace drillwave
