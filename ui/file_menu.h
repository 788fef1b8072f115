// The File menu: new, open, examples, save, recent files, quit, with the question about unsaved changes.
#pragma once

#include <QMenu>

#include "ui/document.h"
#include "ui/questions.h"

namespace drillwave {

class FileMenu : public QMenu {
    Q_OBJECT

  public:
    /// Document and questions must outlive the menu.
    FileMenu(Document& document, Questions& questions, QWidget* window);

    /// Opens a scenario file in place of the present scenario; tells why if it cannot. True when opened.
    bool openFile(const QString& path);
    /// Whether the present scenario may be replaced or closed: saved, unchanged or given up.
    bool mayDiscard();
    bool save();
    bool saveAs();

  private:
    void addFileActions();
    void addExamples();
    void addRecentFiles();
    void remember(const QString& path);
    void showRecentFiles();
    bool saveTo(const QString& path);
    /// Whether there is no problem; tells of one.
    bool succeeded(const QString& what, const QString& problem);

    Document& m_document;
    Questions& m_questions;
    QWidget* m_window;
    QMenu* m_recent = nullptr;
};

}  // namespace drillwave
