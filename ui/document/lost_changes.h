// SPDX-License-Identifier: GPL-3.0-or-later
// Unsaved changes of instances of the program that are no longer alive.
#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QLockFile>
#include <QString>
#include <memory>
#include <string>
#include <vector>

#include "core/yaml/scenario_file.h"

namespace drillwave {

/// What a recovery file says.
struct UnsavedScenario {
    QString name;    ///< as the window showed it
    QString origin;  ///< the file it was an edit of, or empty
    QDateTime time;  ///< of the last change kept
    std::string text;
};

/// The bytes of a recovery file. Throws ScenarioError where the scenario is too large for a file.
QByteArray recoveryBytes(const ScenarioDocument& contents, const QString& name, const QString& origin,
                         const QDateTime& time);

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
