// SPDX-License-Identifier: GPL-3.0-or-later
// A result that is result of an earlier input never looks like one, and is never exported as one.
#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QLabel>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <atomic>
#include <semaphore>

#include "core/archive/result_scenario.h"
#include "core/yaml/examples.h"
#include "tests/support/themes.h"
#include "tests/support/window.h"
#include "tests/support/window_parts.h"
#include "ui/export/export_menu.h"
#include "ui/export/numbers_window.h"
#include "ui/job/solve_job.h"
#include "ui/job/study_status.h"
#include "ui/pages/blow/blow_page.h"
#include "ui/plot/plot_menu.h"
#include "ui/plot/plot_widget.h"
#include "ui/result/result_panel.h"
#include "ui/result/stale_veil.h"

using namespace drillwave;
using namespace drillwave::test;
using namespace std::chrono_literals;

namespace {

/// Solves at once while the gate is open, else one request for every pass that is given.
struct Gate {
    std::atomic<bool> open = true;
    std::atomic<bool> letsQuickPass = false;
    std::counting_semaphore<> passes{0};

    void wait(const std::stop_token& stop) {
        while (!open && !stop.stop_requested())
            if (passes.try_acquire_for(1ms)) return;
    }
};

}  // namespace

class TestStaleResult : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        QLocale::setDefault(QLocale::c());
        keepSettingsIn(m_folder.filePath(QStringLiteral("settings")));
    }

    void init() {
        m_answers = {};
        m_gate = std::make_shared<Gate>();
        m_window = std::make_unique<MainWindow>(
            std::make_unique<ScriptedQuestions>(m_answers),
            [gate = m_gate, solver = std::make_shared<MethodSolver>()](const SolveRequest& request) {
                if (!request.quick || !gate->letsQuickPass) gate->wait(request.stop);
                return solveBlow(request, *solver);
            });
        m_window->resize(1440, 900);  // room for the result beside the scenario
        m_window->show();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        QTRY_VERIFY(status().isCurrent() && !part<SolveJob>(*m_window).isBusy());
        QTRY_VERIFY(panel().text().contains(QStringLiteral("is enough for a single blow at any gap")));
        status().setPatience(0ms);
    }

    void cleanup() {
        m_window.reset();
        QApplication::setPalette(QPalette());
    }

    void aChangeWithoutAnAnswerIsMarked() {
        m_gate->open = false;
        const QString before = panel().text();
        edit(4);
        QVERIFY(!status().isCurrent());
        QTRY_VERIFY(status().isMarked());
        QCOMPARE(status().text(), QStringLiteral("solving …"));
        QVERIFY(status().button()->isVisible());
        QCOMPARE(status().button()->text(), QStringLiteral("Cancel"));
        // Veils of the page and the panel; studies that are not on show have their own.
        const auto seen = [this] {
            QList<StaleVeil*> veils = m_window->findChildren<StaleVeil*>();
            veils.removeIf([](const StaleVeil* veil) { return !veil->isVisible(); });
            return veils.size();
        };
        QCOMPARE(seen(), 2);
        QCOMPARE(panel().text(), StaleVeil::words() + QLatin1Char('\n') + before);
        m_gate->open = true;
        QTRY_VERIFY(status().isCurrent());
        QVERIFY(!status().isMarked() && !status().button()->isVisible());
        QCOMPARE(seen(), 0);
        QVERIFY(status().text().contains(QStringLiteral("e = ")));
        QVERIFY(m_window->shown()->request.scenario == m_window->document().scenario());
    }

    // Words, hatching and less contrast: in light and dark, and not only by colour.
    void theMarkIsSeen_data() {
        QTest::addColumn<bool>("dark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }
    void theMarkIsSeen() {
        QFETCH(bool, dark);
        QApplication::setPalette(dark ? darkPalette() : lightPalette());
        QTRY_VERIFY(status().isCurrent());
        for (QWidget* each : {static_cast<QWidget*>(&panel()), part<BlowPage>(*m_window).parentWidget()}) {
            const int clear = spread(each->grab().toImage());
            m_gate->open = false;
            edit(each == &panel() ? 4 : 5);
            QTRY_VERIFY(status().isMarked());
            const QImage veiled =
                m_window->grab(QRect(each->mapTo(m_window.get(), QPoint(0, 60)), each->size())).toImage();
            QVERIFY2(spread(veiled) < 0.7 * clear, qPrintable(QString::number(spread(veiled))));
            m_gate->open = true;
            QTRY_VERIFY(status().isCurrent());
        }
    }

    void aFastAnswerIsNeverMarked() {
        status().setPatience(1h);
        QSignalSpy marked(&status(), &SolveStatus::marked);
        for (int i = 0; i < 20; ++i) {
            edit(3 + 0.1 * i);
            QTRY_VERIFY(status().isCurrent());
        }
        QCOMPARE(marked.size(), 0);
    }

    void anAnswerToAnEarlierInputStaysMarked() {
        m_gate->open = false;
        edit(4);
        edit(5);
        QTRY_VERIFY(status().isMarked());
        QSignalSpy solved(&part<SolveJob>(*m_window), &SolveJob::solved);
        m_gate->passes.release();
        QTRY_VERIFY(solved.size() == 1 || !part<SolveJob>(*m_window).isBusy());
        QVERIFY(status().isMarked() && !status().isCurrent());
        m_gate->open = true;
        QTRY_VERIFY(status().isCurrent());
        QCOMPARE(m_window->shown()->request.scenario.rod.length, 5.0);
    }

    void cancelStopsAndTheOldResultStaysMarked() {
        m_gate->open = false;
        edit(4);
        QTRY_VERIFY(status().isMarked());
        QTest::mouseClick(status().button(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!part<SolveJob>(*m_window).isBusy(), 60000);
        QVERIFY(status().isMarked() && !status().isCurrent());
        QVERIFY(status().text().startsWith(QStringLiteral("stopped")));
        QCOMPARE(status().button()->text(), QStringLiteral("Solve"));
        m_gate->open = true;
        QTest::mouseClick(status().button(), Qt::LeftButton);
        QTRY_VERIFY(status().isCurrent());
        QVERIFY(!status().isMarked());
        QCOMPARE(m_window->shown()->request.scenario.rod.length, 4.0);
    }

    void anExportWaitsForTheResultOfThePresentInput() {
        m_gate->open = false;
        edit(4);
        m_answers.exportTo = m_folder.filePath(QStringLiteral("late.csv"));
        part<ExportMenu>(*m_window).saveHistories();  // and returns, whatever the solver does
        QVERIFY(!QFile::exists(m_answers.exportTo));
        QVERIFY2(status().text().contains(QStringLiteral("late.csv waits")), qPrintable(status().text()));
        QVERIFY(status().button()->isVisible());
        m_gate->open = true;
        QTRY_VERIFY(QFile::exists(m_answers.exportTo));
        QCOMPARE(loadResultScenario(m_answers.exportTo.toStdString()).scenario.rod.length, 4.0);
        QCOMPARE(m_answers.told, QStringList());
    }

    void aQuickAnswerIsShownAndNoneIsExported() {
        m_window->openExample(*findExample("r32_string"));
        QTRY_VERIFY(status().isCurrent());
        QVERIFY(!m_window->shown()->request.quick);
        m_gate->letsQuickPass = true;
        m_gate->open = false;
        m_window->document().assign(*findParameter("bit_rock.gamma"), 0.3, ++m_gesture);
        QTRY_VERIFY(m_window->shown()->request.scenario == m_window->document().scenario());
        QVERIFY(m_window->shown()->request.quick);
        QVERIFY(!status().isMarked() && !status().isCurrent());
        QVERIFY(status().text().contains(QStringLiteral("efficiency")));
        m_answers.exportTo = m_folder.filePath(QStringLiteral("sure.csv"));
        part<ExportMenu>(*m_window).saveEvents();
        QVERIFY(status().isWaiting() && status().isMarked());
        QVERIFY(!QFile::exists(m_answers.exportTo));
        m_gate->open = true;
        QTRY_VERIFY(status().isCurrent());
        QVERIFY(!m_window->shown()->request.quick);
        QVERIFY(QFile::exists(m_answers.exportTo));
    }

    void everyExportWaits_data() {
        QTest::addColumn<int>("which");
        for (int i = 0; i < 7; ++i) QTest::addRow("%d", i) << i;
    }
    void everyExportWaits() {
        QFETCH(int, which);
        m_gate->open = false;
        QGuiApplication::clipboard()->clear();
        m_answers.exportTo = m_folder.filePath(QStringLiteral("x%1.png").arg(which));
        m_answers.folder = m_folder.filePath(QStringLiteral("folder"));
        m_answers.picture = PictureChoice{QStringLiteral("png"), {120, 80}, 100};
        edit(4);
        ExportMenu& menu = part<ExportMenu>(*m_window);
        QList<QAction*> exports = menu.actions();
        exports.removeIf([](const QAction* action) { return action->isSeparator(); });
        QCOMPARE(exports.size(), 7);
        QSignalSpy exported(&menu, &ExportMenu::exported);
        exports.at(which)->trigger();
        QVERIFY(status().isWaiting());
        QCOMPARE(exported.size(), 0);
        m_gate->open = true;
        if (exports.at(which)->objectName() == QLatin1String("numbersAsTable"))
            QTRY_VERIFY(m_window->findChild<NumbersWindow*>());  // no file
        else
            QTRY_COMPARE(exported.size(), 1);
        QVERIFY(!status().isWaiting());
    }

    void cancelCallsTheExportOff() {
        m_gate->open = false;
        edit(4);
        m_answers.exportTo = m_folder.filePath(QStringLiteral("never.csv"));
        part<ExportMenu>(*m_window).saveHistories();
        QTest::mouseClick(status().button(), Qt::LeftButton);
        QVERIFY(
            m_window->statusBar()->currentMessage().contains(QStringLiteral("never.csv was not written")));
        m_gate->open = true;
        QTest::mouseClick(status().button(), Qt::LeftButton);
        QTRY_VERIFY(status().isCurrent());
        QVERIFY(!QFile::exists(m_answers.exportTo));
    }

    void anEditCallsTheExportOff() {
        m_gate->open = false;
        edit(4);
        m_answers.exportTo = m_folder.filePath(QStringLiteral("changed.csv"));
        part<ExportMenu>(*m_window).saveHistories();
        edit(5);
        QVERIFY(!status().isWaiting());
        m_gate->open = true;
        QTRY_VERIFY(status().isCurrent());
        QVERIFY(!QFile::exists(m_answers.exportTo));
    }

    void anExportAfterAStopSolvesAnew() {
        m_gate->open = false;
        edit(4);
        QTRY_VERIFY(status().isMarked());
        QTest::mouseClick(status().button(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!part<SolveJob>(*m_window).isBusy(), 60000);
        m_gate->open = true;
        m_answers.exportTo = m_folder.filePath(QStringLiteral("again.csv"));
        part<ExportMenu>(*m_window).saveHistories();
        QTRY_VERIFY(QFile::exists(m_answers.exportTo));
        QCOMPARE(loadResultScenario(m_answers.exportTo.toStdString()).scenario.rod.length, 4.0);
    }

    void theMenuOfAPlotCopiesNoOldCurves() {
        const auto copyEnabled = [this] {
            const std::unique_ptr<QMenu> menu(new PlotMenu(*part<BlowPage>(*m_window).plot(), {100, 100}));
            int enabled = 0;
            for (const QAction* action : menu->actions())
                enabled += action->text().startsWith(QStringLiteral("Copy")) && action->isEnabled();
            return enabled;
        };
        const auto* button = part<BlowPage>(*m_window).findChild<QToolButton*>(QStringLiteral("copyReadout"));
        QCOMPARE(copyEnabled(), 3);
        QVERIFY(button->isEnabled());
        m_gate->open = false;
        edit(4);
        QCOMPARE(copyEnabled(), 0);
        QVERIFY(!button->isEnabled());
        m_gate->open = true;
        QTRY_VERIFY(status().isCurrent());
        QCOMPARE(copyEnabled(), 3);
        QVERIFY(button->isEnabled());
    }

  private:
    SolveStatus& status() { return part<SolveStatus>(*m_window); }
    ResultPanel& panel() { return part<ResultPanel>(*m_window); }
    void edit(double metres) {
        m_window->document().assign(*findParameter("rod.length"), metres, ++m_gesture);
    }

    /// From the darkest to the lightest per cent of the pixels.
    static int spread(const QImage& image) {
        QList<int> greys;
        for (int y = 0; y < image.height(); y += 2)
            for (int x = 0; x < image.width(); x += 2) greys.append(qGray(image.pixel(x, y)));
        std::sort(greys.begin(), greys.end());
        return greys[greys.size() * 99 / 100] - greys[greys.size() / 100];
    }

    QTemporaryDir m_folder;
    ScriptedAnswers m_answers;
    std::shared_ptr<Gate> m_gate;
    std::unique_ptr<MainWindow> m_window;
    int m_gesture = 0;
};

QTEST_MAIN(TestStaleResult)
#include "tst_stale_result.moc"
