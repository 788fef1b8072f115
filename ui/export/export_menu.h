// SPDX-License-Identifier: GPL-3.0-or-later
// Menu File ▸ Export, which writes results and pictures of the present blow to files.
#pragma once

#include <QMenu>
#include <functional>

#include "core/archive/result_files.h"
#include "ui/document/document.h"
#include "ui/job/solved_blow.h"
#include "ui/pages/page_export.h"
#include "ui/questions/questions.h"

namespace drillwave {

class ExportMenu : public QMenu {
    Q_OBJECT

  public:
    /// Functions by which the menu gets the blow to export.
    struct Sources {
        /// Function that returns the answer for the present scenario, solved or failed; nullptr until it is
        /// computed.
        std::function<SolvedBlowPtr()> blow;
        /// Function that calls `then` when the result is solved and shown: at once or later; never if the
        /// user cancels. `what` is the name of the waiting export for messages.
        std::function<void(const QString& what, std::function<void()> then)> whenSolved;
    };

    /// Makes the menu. `window` is the parent of its dialogs; document and questions must outlive the menu.
    ExportMenu(Document& document, Questions& questions, Sources sources, QWidget* window);

    /// Sets the exports that the visible page offers, which become entries of the menu.
    void setExports(const QList<PageExport>& exports);
    /// Asks for a file name and writes one export (plot or table of the page) to it. Tables of numbers begin
    /// with the scenario as comment lines.
    void save(const PageExport& wanted);
    /// Shows the present numbers of the page as a table in a separate window.
    void showNumbers();
    /// Asks for a file and writes the curves over time of the blow as CSV, in the units shown.
    void saveHistories();
    /// Asks for a file and writes the events of the blow as CSV, in the units shown.
    void saveEvents();
    /// Asks for a folder and writes the files of `drillwave run FILE -o FOLDER --plots png,svg,pdf`; see
    /// runFolder().
    void saveEverything();

  signals:
    /// Emitted after an export; `message` says in one line where the file is.
    void exported(const QString& message);

  protected:
    /// Keeps Ctrl+E for this menu: line edits on X11 would use it as "end of line".
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    using MakeFile = std::function<std::string(const SolvedRun&)>;
    using UseRun = std::function<void(const SolvedRun&)>;
    QAction* add(const QString& text, const QKeySequence& keys, const QString& toolTip,
                 const std::function<void()>& then, QAction* before = nullptr);
    void savePicture(const PageExport& wanted);
    void copyPicture();
    void saveFile(const QString& title, const QString& ending, const MakeFile& make);
    void writeFolder(const QString& folder, SolvedRun run, ExistingFiles existing);
    void writePicture(const QString& path, const PageExport& wanted, const PictureChoice& choice);
    /// Returns true if the scenario could not be solved, and shows the reason to the user.
    bool isUnsolved();
    /// Calls `use` with the result as soon as it is solved. `what` is the name of the waiting export for
    /// messages.
    void withRun(const QString& what, const UseRun& use);
    /// Returns the result of the blow in the form in which it is written to files. Throws ScenarioError if
    /// the scenario, with the points of its force table, is too large for a file.
    SolvedRun solvedRun() const;
    QString suggestion(const QString& ending) const;
    void finish(const QString& path, const QString& problem);
    void fail(const QString& problem);

    Document& m_document;
    Questions& m_questions;
    Sources m_sources;
    QWidget* m_window;
    QList<PageExport> m_exports;
    QList<QAction*> m_actions;  // menu entries of m_exports, in the same order
    QAction* m_histories = nullptr;
    QAction* m_numbers = nullptr;
    QAction* m_afterPictures = nullptr;
};

}  // namespace drillwave
