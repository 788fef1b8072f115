// SPDX-License-Identifier: GPL-3.0-or-later
// Fixture with a new window for each test, and access to its fields.
#pragma once

#include <QTemporaryDir>
#include <QTest>

#include "tests/support/window.h"
#include "tests/support/window_parts.h"
#include "ui/form/quantity_field.h"
#include "ui/form/scenario_panel.h"
#include "ui/job/solve_job.h"
#include "ui/text/settings.h"

namespace drillwave::test {

/// Replaces the text of a field and presses Enter.
inline void type(QuantityField& field, const QString& text) {
    field.setFocus();
    field.selectAll();
    QTest::keyClick(&field, Qt::Key_Backspace);
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
}

/// Fixture whose settings and files are in a temporary folder.
class WindowFixture {
  protected:
    WindowFixture() { keepSettingsIn(m_folder.filePath(QStringLiteral("settings"))); }

    /// Makes a new window, as at the first start of the program.
    void start() {
        QLocale::setDefault(QLocale::c());
        Settings().clear();
        m_answers = {};
        makeWindow(exactSolve());
    }
    void makeWindow(SolveJob::Solve solve) {
        m_window = newWindow(m_answers, std::move(solve));
        m_window->show();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    }
    MainWindow& window() { return *m_window; }
    QuantityField& field(const char* key) {
        return *part<ScenarioPanel>(*m_window).findChild<QuantityField*>(QLatin1String(key));
    }
    double cor() const { return m_window->shown()->summary.cor; }
    void settle() {
        constexpr int patience = 60000;  // enough with sanitizers on a busy machine [ms]
        QTRY_VERIFY_WITH_TIMEOUT(!part<SolveJob>(*m_window).isBusy(), patience);
    }

    QTemporaryDir m_folder;
    ScriptedAnswers m_answers;
    std::unique_ptr<MainWindow> m_window;
};

}  // namespace drillwave::test
