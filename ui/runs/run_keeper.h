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
/// Opening a scenario also opens the runs in its folder. Runs of the scenario before are removed if they are
/// stored with it; otherwise they stay in the list. While storing is switched on, every change is written.
/// After "save as" the runs are also written beside the new file, unless other runs are there.
///
/// A separate thread writes, one job after another. If several changes arrive during a job, only the last
/// one is written.
class RunKeeper : public QObject {
    Q_OBJECT

  public:
    /// Function that writes files into the folder, on any thread, such as RunsFolder::write(). Returns why it
    /// failed, or an empty message.
    using Write = std::function<Message(RunsFolder&, const std::vector<NamedFile>&, ExistingFiles)>;

    /// Creates the object. Document and runs must outlive it.
    RunKeeper(Document& document, Runs& runs, QObject* parent = nullptr, Write write = &RunsFolder::write);
    /// Writes the remaining changes. A failure is not reported, because receivers of signals may no longer
    /// exist.
    ~RunKeeper() override;

    /// Returns whether storing is switched on. It is switched off when writing fails.
    bool isKept() const { return m_kept; }
    /// Returns the folder of the present scenario; empty if the scenario has no file.
    QString folder() const;
    /// Returns whether the folder contains files that do not belong to the runs shown and would remain. The
    /// user should be asked before keep().
    bool holdsOthers();
    /// Switches storing on and starts writing. Returns why this is impossible, or an empty text. A later
    /// failure is reported by failed() or finish(). Files of other programs are replaced only with
    /// ExistingFiles::replaced.
    QString keep(ExistingFiles existing = ExistingFiles::kept);
    /// Switches storing off and removes the files of the runs, except files that another program has changed.
    /// Removes the folder too if it is empty then.
    void giveUp();
    /// Waits until everything is written. Returns why writing has failed, without emitting failed(); storing
    /// is then switched off. Empty on success.
    QString finish();

  signals:
    /// Reports that storing was switched on or off.
    void keptChanged(bool kept);
    /// Reports that the scenario was saved under a name that has a folder of runs already. Nothing is written
    /// there until keep() is called.
    void othersFound(const QString& folder);
    /// Reports that runs could not be read or written. `problem` gives the reasons, one per line.
    void failed(const QString& what, const QString& problem);

  private:
    /// Order to write the runs to files, in the state that they have when writing starts.
    struct Order {
        enum class Reason { wish, change } reason;
        ExistingFiles existing;
        QString failure;  ///< first part of the message if writing fails
    };
    /// Job that writes files, used by one thread at a time. The worker uses it until it has delivered the
    /// result, another thread only after waiting for the worker.
    struct Job {
        Write write;
        RunsFolder folder;
        std::vector<NamedFile> files;
        ExistingFiles existing;
        /// Empty optional until done; then the reason of a failure, or an empty message.
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
