// SPDX-License-Identifier: GPL-3.0-or-later
// Unsaved changes kept on disk while the program runs, for the case that it ends unexpectedly.
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

// Unsaved changes of instances of the program that are no longer alive.

/// Pinned runs and measured signals of a window, beside its document.
struct WorkBeside {
    std::vector<KeptRun> runs;  ///< pinned
    std::vector<MeasuredSignal> measured;
};

/// Contents of a recovery file.
struct UnsavedScenario {
    QString name;    ///< as the window showed it
    QString origin;  ///< the file it was an edit of, or empty
    QString path;    ///< where it was saved to; empty for results, examples and new scenarios
    QDateTime time;  ///< of the last change kept
    std::string text;
    std::string saved;  ///< what the file at `path` held
    WorkBeside beside;
    QStringList problems;    ///< what of it could not be read, a line each
    bool isUnsaved = true;   ///< false only where a window without changes was to be opened again
    bool isRestart = false;  ///< the user has asked for a new window: restore without a question
};

/// The bytes of a recovery file, with the text of `contents`. Throws ScenarioError where the scenario is too
/// large for a file.
QByteArray recoveryBytes(const ScenarioDocument& contents, const UnsavedScenario& record);

/// A recovery file that belongs to no living instance. While this exists no other instance takes it.
class LostChanges {
  public:
    LostChanges(const QString& file, std::unique_ptr<QLockFile> lock);

    const UnsavedScenario& scenario() const { return m_scenario; }
    /// Why the file cannot be used; empty when it can.
    const QString& problem() const { return m_problem; }
    /// Removes the file.
    void discard();
    /// Renames the file so that it is not found again, and returns its new name.
    QString setAside();

  private:
    QString m_file;
    std::unique_ptr<QLockFile> m_lock;
    UnsavedScenario m_scenario;
    QString m_problem;
};

/// Finds all in the folder, the last change first.
std::vector<LostChanges> findLostChanges(const QString& folder);

/// Writes the unsaved scenario of a document to a file of its own in `folder` within a second of a change,
/// away from the window's thread, whole or not at all, and removes it when there is nothing unsaved. A lock
/// beside the file tells other instances that this one is alive.
class Recovery : public QObject {
    Q_OBJECT

  public:
    /// Makes the folder. The document must outlive the recovery.
    Recovery(const Document& document, const QString& folder, QObject* parent = nullptr);
    /// Leaves the file; call end() first if nothing needs recovery.
    ~Recovery() override;

    /// Stores the return value of `beside` with the scenario.
    void keepBeside(std::function<WorkBeside()> beside) { m_beside = std::move(beside); }
    /// Notes a change beside the document.
    void writeSoon();
    /// Writes what is unsaved and returns when it is on the disk.
    void writeNow();
    /// Writes everything, unsaved or not, for a window that replaces this one and asks nothing. False if that
    /// has failed.
    bool writeForRestart();
    /// Removes the file, as nothing needs recovery any more. A later change writes it again.
    void end();
    QString file() const { return m_file; }

  signals:
    /// Changes cannot be kept, for the reason `problem`. Emitted once.
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

/// The folder in which every instance of the program keeps its unsaved changes.
QString recoveryFolder();

}  // namespace drillwave
