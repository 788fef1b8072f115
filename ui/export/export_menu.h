// SPDX-License-Identifier: GPL-3.0-or-later
// File ▸ Export: results and pictures of the blow that is shown, as files.
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
    /// Sources of the exports.
    struct Sources {
        /// Returns the document's scenario as it is now, solved or not; nullptr until an answer is there.
        std::function<SolvedBlowPtr()> blow;
        /// Calls `then` when blow() is solved and shown: at once, later, or never if it is called off. `what`
        /// names the waiting export.
        std::function<void(const QString& what, std::function<void()> then)> whenSolved;
    };

    /// Document and questions must outlive the menu.
    ExportMenu(Document& document, Questions& questions, Sources sources, QWidget* window);

    /// Sets the exports of the page on show, which the menu then offers.
    void setExports(const QList<PageExport>& exports);
    /// Writes one of the exports, the numbers with the scenario in front.
    void save(const PageExport& wanted);
    /// Shows the present numbers of the page in a window of their own.
    void showNumbers();
    /// The curves and the events of the blow, in the units that are shown.
    void saveHistories();
    void saveEvents();
    /// The files that `drillwave run FILE -o FOLDER --plots png,svg,pdf` writes; see runFolder().
    void saveEverything();

  signals:
    /// Something has been written: where, in one line.
    void exported(const QString& message);

  protected:
    /// Line edits on X11 would take Ctrl+E as "end of line".
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
    /// Whether the scenario has no solution; reports that to the user.
    bool isUnsolved();
    /// Hands the blow over when there is one; `what` waits for it.
    void withRun(const QString& what, const UseRun& use);
    /// Returns the solved blow in the form for files. Throws ScenarioError if the scenario with the points of
    /// its table is too large for a file.
    SolvedRun solvedRun() const;
    QString suggestion(const QString& ending) const;
    void finish(const QString& path, const QString& problem);
    void fail(const QString& problem);

    Document& m_document;
    Questions& m_questions;
    Sources m_sources;
    QWidget* m_window;
    QList<PageExport> m_exports;
    QList<QAction*> m_actions;  // of m_exports
    QAction* m_histories = nullptr;
    QAction* m_numbers = nullptr;
    QAction* m_afterPictures = nullptr;
};

}  // namespace drillwave
