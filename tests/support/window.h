// SPDX-License-Identifier: GPL-3.0-or-later
// Complete window as in the program, except for its questions and the location of its settings.
#pragma once

#include <QSettings>

#include "tests/support/scripted_questions.h"
#include "ui/window/main_window.h"

namespace drillwave::test {

/// Returns a solver like that of the program.
inline SolveJob::Solve exactSolve() {
    return [solver = std::make_shared<MethodSolver>()](const SolveRequest& request) {
        return solveBlow(request, *solver);
    };
}

/// Returns a window whose questions get these answers; `answers` must outlive it.
inline std::unique_ptr<MainWindow> newWindow(ScriptedAnswers& answers, SolveJob::Solve solve = exactSolve()) {
    return std::make_unique<MainWindow>(std::make_unique<ScriptedQuestions>(answers), std::move(solve));
}

/// Makes this process read and write its settings in a folder instead of the user's.
inline void keepSettingsIn(const QString& folder) {
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder);
}

}  // namespace drillwave::test
