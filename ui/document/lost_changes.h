// SPDX-License-Identifier: GPL-3.0-or-later
// Unsaved changes of instances of the program that are no longer alive.
#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QLockFile>
#include <QString>
#include <QStringList>
#include <memory>
#include <string>
#include <vector>

#include "core/archive/kept_runs.h"
#include "core/signal/alignment.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {

/// Pinned runs and measured signals of a window, beside its document.
struct WorkBeside {
    std::vector<KeptRun> runs;  ///< pinned
    std::vector<MeasuredSignal> measured;
};

/// What a recovery file says.
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
    bool isRestart = false;  ///< the user has asked for a new window: nothing is to be asked
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

/// All in the folder, the last change first.
std::vector<LostChanges> findLostChanges(const QString& folder);

}  // namespace drillwave
