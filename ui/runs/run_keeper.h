// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the runs in a folder beside the scenario file, if the user wants that.
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

/// An opened scenario brings the runs of its folder with it; those of the scenario before go if they
/// are kept, and stay beside the new ones if nothing else has them. While runs are kept, every change
/// of them is written, and after "save as" beside the new file, if there are no others. A separate
/// thread waits for the disk, one writing after another; only the last of several changes meanwhile is
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
    /// Whether the folder has files that are not of the runs on show, and would stay: ask the user first.
    bool holdsOthers();
    /// Keeps the runs from now on; begins to write. Returns why not; then nothing is kept. A failure of
    /// writing is reported by failed(), or by finish().
    /// Replaces files of other programs only for ExistingFiles::replaced.
    QString keep(ExistingFiles existing = ExistingFiles::kept);
    /// Keeps the runs no more; removes the files of the runs, except those that another program has changed,
    /// and the folder if nothing else is in it.
    void giveUp();
    /// Waits until all is written. Returns why that has failed, without failed(); then nothing is kept any
    /// more.
    QString finish();

  signals:
    void keptChanged(bool kept);
    /// Saved under a name with such a folder already: nothing is kept there until keep() is called.
    void othersFound(const QString& folder);
    /// Some runs could not be taken from their files, or not be written: why, line by line.
    void failed(const QString& what, const QString& problem);

  private:
    /// Runs to write, as they are when writing begins.
    struct Order {
        enum class Reason { wish, change } reason;
        ExistingFiles existing;
        QString failure;  ///< the message if it fails
    };
    /// One writing, for one thread at a time: the worker's until it delivers, or until another thread has
    /// waited for it.
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
    QString m_failure;             // the message if the last order fails
    Worker m_worker;
};

}  // namespace drillwave
