// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the pinned runs in a folder beside the scenario file, if the user wants that.
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "core/archive/kept_runs.h"
#include "ui/document/document.h"
#include "ui/job/worker.h"
#include "ui/runs/runs.h"

namespace drillwave {

/// Storage of the pinned runs (results kept for comparison) in files.
///
/// Opening a scenario also opens the runs stored in its folder. The runs listed before are then removed from
/// the list if they are stored; otherwise they stay in it. While storing is switched on, every change is
/// written. After "save as" the runs are also written beside the new file, unless other runs are there.
///
/// A separate thread writes one state of the list after another. If several changes arrive while it writes,
/// only the state after the last one is written.
class RunKeeper : public QObject {
    Q_OBJECT

  public:
    /// Function that writes files into the folder of the runs, on any thread, such as RunsFolder::write().
    /// Returns why it failed, or an empty message.
    using Write = std::function<Message(RunsFolder&, const std::vector<NamedFile>&, ExistingFiles)>;

    /// Creates the object. Document and runs must outlive it. `write` writes the files; tests pass another
    /// function.
    RunKeeper(Document& document, Runs& runs, QObject* parent = nullptr, Write write = &RunsFolder::write);
    /// Waits until all changes are written. A failure is not reported, because receivers of signals may no
    /// longer exist.
    ~RunKeeper() override;

    /// Returns whether the pinned runs are being stored in files. Storing is switched off when writing fails.
    bool isKept() const { return m_kept; }
    /// Returns the folder beside the scenario file in which its pinned runs are stored; empty if the scenario
    /// has no file.
    QString folder() const;
    /// Returns whether the folder for the pinned runs already contains runs or files that are not from the
    /// present list. The user should be asked before keep().
    bool holdsOthers();
    /// Switches the storing of the pinned runs on, and starts writing. Returns why this is impossible, or an
    /// empty text. A later failure is reported by failed() or finish(). Files that belong to others are
    /// replaced only with ExistingFiles::replaced.
    QString keep(ExistingFiles existing = ExistingFiles::kept);
    /// Switches storing off and removes the files of the runs, except files that another program has changed.
    /// Removes the folder too if it is empty then.
    void giveUp();
    /// Waits until all changes of the runs are written. Returns why writing has failed, without emitting
    /// failed(); storing is then switched off. Empty on success.
    QString finish();

  signals:
    /// Reports that storing the pinned runs in files was switched on or off.
    void keptChanged(bool kept);
    /// Reports that "save as" gave the scenario a name for which a folder of runs exists already. Nothing is
    /// written there until keep() is called.
    void othersFound(const QString& folder);
    /// Reports that runs could not be read or written. `what` is a sentence on the consequence for the user,
    /// such as "The runs are not kept."; `problem` gives the reasons, one per line.
    void failed(const QString& what, const QString& problem);

  private:
    /// Request to write the pinned runs to files. It does not contain the runs: those present when writing
    /// starts are written.
    struct Order {
        enum class Reason { wish, change } reason;
        ExistingFiles existing;
        QString failure;  ///< first part of the message if writing fails
    };
    /// Files to write, with the result of writing them. A worker thread uses the job until it has delivered
    /// the result. Another thread may use it only after waiting for the worker.
    struct Job {
        Write write;
        RunsFolder folder;
        std::vector<NamedFile> files;
        ExistingFiles existing;
        /// Reason why writing failed, or an empty message on success. Empty optional until the job is done.
        std::optional<Message> problem;
        std::vector<int> foreignNumbers;
        void run();
    };

    void leave();
    void read();
    void followSaved();
    void moveTo(const QString& path);
    std::vector<NamedFile> files() const;
    void writeSoon();
    void order(Order order);
    void begin();
    QString prepare();
    QString take();
    QString fail(const QString& problem);
    void finishAndTell();
    void setKept(bool kept);

    Document& m_document;
    Runs& m_runs;
    const Write m_write;
    QTimer m_due;
    QString m_path;  // path of the scenario file that the folder belongs to
    bool m_kept = false;
    bool m_partial = false;        // whether the folder contains runs that are not in the list
    RunsFolder m_folder;           // state of the folder before m_job
    std::optional<Order> m_order;  // request that is not yet a job
    std::shared_ptr<Job> m_job;    // job that is being executed
    QString m_failure;             // first part of the message if the last request fails
    Worker m_worker;
};

}  // namespace drillwave
