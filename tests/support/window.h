// SPDX-License-Identifier: GPL-3.0-or-later
// The whole window, as the program makes it but for its questions and the place of its settings.
#pragma once

#include <QSettings>

#include "tests/support/scripted_questions.h"
#include "ui/window/main_window.h"

namespace drillwave::test {

/// Solves as the program does.
inline SolveJob::Solve exactSolve() {
    return [solver = std::make_shared<MethodSolver>()](const SolveRequest& request) {
        return solveBlow(request, *solver);
    };
}

/// A window whose questions get these answers, which must outlive it.
inline std::unique_ptr<MainWindow> newWindow(ScriptedAnswers& answers, SolveJob::Solve solve = exactSolve()) {
    return std::make_unique<MainWindow>(std::make_unique<ScriptedQuestions>(answers), std::move(solve));
}

/// Settings of this process from now on are read and written in a folder, and not in the user's.
inline void keepSettingsIn(const QString& folder) {
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder);
}

}  // namespace drillwave::test
