// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the runs in a folder beside the scenario file, where the user wants that.
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

/// A scenario that is opened brings the runs of its folder with it; those of the scenario before go where
/// they are kept, and stay beside the new ones where nothing else has them. While runs are kept, every change
/// of them is written, and after "save as" beside the new file, where there are no others. The disk is waited
/// for on a thread of its own, one writing after another; of what changes meanwhile only the last state is
/// written.
class RunKeeper : public QObject {
    Q_OBJECT

  public:
    /// Writes files into the folder, on any thread, as RunsFolder::write() does.
    using Write = std::function<Message(RunsFolder&, const std::vector<NamedFile>&, ExistingFiles)>;

    /// Document and runs must outlive it.
    RunKeeper(Document& document, Runs& runs, QObject* parent = nullptr, Write write = &RunsFolder::write);
    /// Writes the rest. Reports no failure, because the receivers may be gone already.
    ~RunKeeper() override;

    /// Wanted, as far as no writing has failed.
    bool isKept() const { return m_kept; }
    /// The folder of the present scenario; empty where that has no file.
    QString folder() const;
    /// The files that are there but not of the runs on show, and would stay: to be asked about first.
    bool holdsOthers();
    /// From now on; begins to write. Returns why not; then nothing is kept. That writing has failed comes
    /// with failed(), or from finish().
    /// Replaces files of other programs only for ExistingFiles::replaced.
    QString keep(ExistingFiles existing = ExistingFiles::kept);
    /// From now on no more; takes the files of the runs, but for those that somebody else has changed, and
    /// the folder where nothing else is in it, away.
    void giveUp();
    /// Waits until all is written. Returns why that has failed, without failed(); then nothing is kept any
    /// more.
    QString finish();

  signals:
    void keptChanged(bool kept);
    /// Saved under a name beside which this folder is already: nothing is kept there until keep() is called.
    void othersFound(const QString& folder);
    /// Some runs could not be taken from their files, or not be written: why, line by line.
    void failed(const QString& what, const QString& problem);

  private:
    /// Runs to write, as they are when writing begins.
    struct Order {
        enum class Reason { wish, change } reason;
        ExistingFiles existing;
        QString failure;  ///< what to say where it fails
    };
    /// One writing, for one thread at a time: the worker's, until it delivers, or until it has been waited
    /// for.
    struct Job {
        Write write;
        RunsFolder folder;
        std::vector<NamedFile> files;
        ExistingFiles existing;
        std::optional<Message> problem;  ///< there when it is done, empty where it has not failed
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
    QString m_path;  // of the scenario file whose folder it is
    bool m_kept = false;
    bool m_partial = false;        // not all that is in the folder is on show
    RunsFolder m_folder;           // before m_job
    std::optional<Order> m_order;  // what no job has been made of yet
    std::shared_ptr<Job> m_job;    // on its way
    QString m_failure;             // what to say where the last order fails
    Worker m_worker;
};

}  // namespace drillwave
