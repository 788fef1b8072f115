// SPDX-License-Identifier: GPL-3.0-or-later
// File ▸ Export: results and pictures of the blow that is shown, as files.
#pragma once

#include <QMenu>
#include <functional>

#include "ui/document/document.h"
#include "ui/export/run_files.h"
#include "ui/export/whole_folder.h"
#include "ui/job/solved_blow.h"
#include "ui/questions/questions.h"

namespace drillwave {

class PlotWidget;

class ExportMenu : public QMenu {
    Q_OBJECT

  public:
    /// Where the menu finds what it exports.
    struct Sources {
        /// Of the document's scenario as it is now, solved or not; nullptr while that is on its way.
        std::function<SolvedBlowPtr()> blow;
        std::function<PlotWidget*()> plot;  ///< of the page that is shown
        /// Calls `then` when blow() is there and shown: at once, or later, or never when that is called off.
        /// `what` names what waits.
        std::function<void(const QString& what, std::function<void()> then)> whenSolved;
    };

    /// Document and questions must outlive the menu.
    ExportMenu(Document& document, Questions& questions, Sources sources, QWidget* window);

    /// The curves and the events of the blow, in the units that are shown.
    void saveHistories();
    void saveEvents();
    /// The files that `drillwave run FILE -o FOLDER --plots png,svg,pdf` writes; see writeRunFolder().
    void saveEverything();
    /// The plot of the page as it is zoomed, on white.
    void savePicture();
    void copyPicture();
    /// The data of the curves that the plot shows, behind the scenario.
    void saveData();

  signals:
    /// Something has been written: where, in one line.
    void exported(const QString& message);

  protected:
    /// Line edits on X11 would take Ctrl+E as "end of line".
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    using MakeFile = std::function<QByteArray(const SolvedRun&)>;
    using UseRun = std::function<void(const SolvedRun&)>;
    void saveFile(const QString& title, const QString& ending, const MakeFile& make);
    void writeFolder(const QString& folder, SolvedRun run, ExistingFiles existing);
    void writePicture(const QString& path, const PictureChoice& choice);
    /// Whether it is known, and told, that there is nothing to be written.
    bool isUnsolved();
    /// Hands the blow over when there is one; `what` waits for it.
    void withRun(const QString& what, const UseRun& use);
    /// The solved blow as it is written. Throws ScenarioError where the scenario with the points of its table
    /// is too large for a file.
    SolvedRun solvedRun() const;
    QString suggestion(const QString& ending) const;
    void finish(const QString& path, const QString& problem);
    void fail(const QString& problem);

    Document& m_document;
    Questions& m_questions;
    Sources m_sources;
    QWidget* m_window;
};

}  // namespace drillwave
