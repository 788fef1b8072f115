// SPDX-License-Identifier: GPL-3.0-or-later
// Unsaved changes stored on disk while the program runs, in case it ends unexpectedly.
#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QLockFile>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QThreadPool>
#include <QTimer>
#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/archive/kept_runs.h"
#include "core/signal/alignment.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {

class Document;

// Reading the unsaved changes of instances of the program that have crashed.

/// Work of a window besides the scenario: pinned runs (results kept for comparison) and measured signals.
/// They are stored in the recovery file too.
struct WorkBeside {
    std::vector<KeptRun> runs;  ///< pinned runs: results kept for comparison
    std::vector<MeasuredSignal> measured;
};

/// Contents of a recovery file: an unsaved scenario, the paths of its files, and the pinned runs and measured
/// signals of its window.
struct UnsavedScenario {
    QString name;    ///< name of the scenario as shown in the window
    QString origin;  ///< file from which the scenario was read; may be empty
    QString path;    ///< file to which it was saved; empty for results, examples and new scenarios
    QDateTime time;  ///< time of the last change that was stored
    std::string text;
    std::string saved;  ///< contents of the file `path` when last read or written
    WorkBeside beside;
    QStringList problems;   ///< reasons why runs could not be read, one line each
    bool isUnsaved = true;  ///< false only if a window without changes is to be opened again
    /// True if the user restarted the window, for example to change its language. The contents are then
    /// restored without asking.
    bool isRestart = false;
};

/// Returns the bytes of a recovery file: the scenario text written from `contents`, and all other data of
/// `record`. Throws ScenarioError if the scenario exceeds the size limit of scenario files.
QByteArray recoveryBytes(const ScenarioDocument& contents, const UnsavedScenario& record);

/// Recovery file of an instance of the program that has crashed. While this object exists, no other instance
/// takes the file.
class LostChanges {
  public:
    LostChanges(const QString& file, std::unique_ptr<QLockFile> lock);

    const UnsavedScenario& scenario() const { return m_scenario; }
    /// Returns why the recovery file cannot be used, such as damaged contents; empty if it can.
    const QString& problem() const { return m_problem; }
    /// Deletes the recovery file, because its changes have been restored or the user does not want them.
    void discard();
    /// Renames an unusable recovery file, so that it is not offered to the user again. Returns its new path,
    /// or its old path if renaming fails.
    QString setAside();

  private:
    QString m_file;
    std::unique_ptr<QLockFile> m_lock;
    UnsavedScenario m_scenario;
    QString m_problem;
};

/// Returns all recovery files of crashed instances in the folder, the latest first.
std::vector<LostChanges> findLostChanges(const QString& folder);

/// Writer of a document's unsaved changes to a recovery file of its own in `folder`. It writes within a
/// second of a change, in another thread, and completely or not at all. It deletes the file when nothing is
/// unsaved. A lock file shows other instances that this one is running.
class Recovery : public QObject {
    Q_OBJECT

  public:
    /// Creates the folder and starts watching the document, which must outlive this object.
    Recovery(const Document& document, const QString& folder, QObject* parent = nullptr);
    /// Leaves the recovery file on the disk, because the program may be ending unexpectedly. Call end() first
    /// if nothing needs recovery.
    ~Recovery() override;

    /// Sets the function that returns the pinned runs and measured signals to store with the scenario.
    void keepBeside(std::function<WorkBeside()> beside) { m_beside = std::move(beside); }
    /// Writes the recovery file within a second, because pinned runs or measured signals have changed.
    void writeSoon();
    /// Writes the unsaved changes to the recovery file at once. Returns when the file is written.
    void writeNow();
    /// Writes the recovery file even if nothing is unsaved, because the window is about to be restarted. The
    /// new window restores the contents without asking. Returns false on failure.
    bool writeForRestart();
    /// Deletes the recovery file; called when the window closes normally. A later change of the document
    /// would write the file again.
    void end();
    QString file() const { return m_file; }

  signals:
    /// Emitted when unsaved changes cannot be written to the recovery file, but only the first time.
    /// `problem` is the reason.
    void failed(const QString& problem);

  private:
    void write();
    UnsavedScenario record() const;
    void report(const QString& problem);

    const Document& m_document;
    std::function<WorkBeside()> m_beside = [] { return WorkBeside(); };
    QString m_file;
    QLockFile m_lock;
    QTimer m_delay;
    QThreadPool m_pool;
    std::atomic<bool> m_isWriting = false;
    bool m_hasFailed = false;
};

/// Returns the folder in which all instances of the program store their unsaved changes.
QString recoveryFolder();

}  // namespace drillwave
