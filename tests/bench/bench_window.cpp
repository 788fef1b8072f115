// SPDX-License-Identifier: GPL-3.0-or-later
// Milliseconds from a keystroke in a field to the new pixels of the whole window, page by page, of a rod and
// of a drill string, and from a step of a slider to those of a map, of designs and of many blows, first and
// whole; then the longest wait for a record of a million samples: bench_window [REPEATS], 50 by default. Not
// run by ctest but for a trial: times depend on the machine.
#include <QLabel>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <optional>
#include <random>
#include <string>

#include "core/report/gauge_record.h"
#include "core/study/identify/gauge_noise.h"
#include "core/yaml/examples.h"
#include "tests/bench/bench_program.h"
#include "tests/support/slider_drag.h"
#include "tests/support/window_parts.h"
#include "ui/form/quantity_field.h"
#include "ui/form/scenario_panel.h"
#include "ui/job/solve_job.h"
#include "ui/pages/design/design_page.h"
#include "ui/pages/drilling/drilling_page.h"
#include "ui/pages/identify/identify_page.h"
#include "ui/pages/map/map_page.h"
#include "ui/pages/plot_page.h"
#include "ui/pages/study/figure_page.h"
#include "ui/plot/figure_frame.h"
#include "ui/plot/plot_widget.h"
#include "ui/window/page_tabs.h"

using namespace drillwave;

namespace {

using Clock = std::chrono::steady_clock;

// Notices when a plot has been painted with the answer to the present scenario.
class PaintWatch : public QObject {
  public:
    explicit PaintWatch(MainWindow& window) : m_window(window) {}
    bool isPainted() const { return m_painted; }
    void expect() { m_painted = false; }

  protected:
    bool eventFilter(QObject* /*plot*/, QEvent* event) override {
        if (event->type() == QEvent::Paint &&
            m_window.shown()->request.scenario == m_window.document().scenario())
            m_painted = true;
        return false;
    }

  private:
    MainWindow& m_window;
    bool m_painted = false;
};

double millisecondsToPixels(QuantityField& field, Qt::Key key, PaintWatch& watch) {
    const Scenario before = static_cast<MainWindow*>(field.window())->document().scenario();
    watch.expect();
    const Clock::time_point start = Clock::now();
    QTest::sendKeyEvent(QTest::Click, &field, key, key == Qt::Key_1 ? QStringLiteral("1") : QString(),
                        Qt::NoModifier);
    // The event that paints also brings the pixels to the window's surface before it returns.
    while (!watch.isPainted()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    const std::chrono::duration<double, std::milli> time = Clock::now() - start;
    if (static_cast<MainWindow*>(field.window())->document().scenario() == before)
        qFatal("the keystroke has changed nothing");
    return time.count();
}

void settle(MainWindow& window) {
    do QTest::qWait(50);
    while (part<SolveJob>(window).isBusy());
}

void printTimes(const QString& name, std::vector<double> times) {
    std::ranges::sort(times);
    std::printf("%-36s %8.1f %8.1f %8.1f\n", qPrintable(name), times[times.size() / 2], times.front(),
                times.back());
}

void measurePage(MainWindow& window, const QString& name, int repeats) {
    auto* page = qobject_cast<PlotPage*>(window.findChild<PageTabs*>()->currentWidget());
    if (!page) return;  // a table
    // of a string it tells in words that there is nothing to draw
    if (qobject_cast<FigurePage*>(page) && isString(window.document().scenario())) return;
    PaintWatch watch(window);
    page->plot()->installEventFilter(&watch);
    // Where the plot does not depend on the field, as a map does not on its own parameters, words do.
    for (const char* words : {"answer", "words"})
        if (auto* label = page->findChild<QLabel*>(QLatin1String(words))) label->installEventFilter(&watch);
    auto* field = part<ScenarioPanel>(window).findChild<QuantityField*>(QStringLiteral("gamma"));
    field->setFocus();
    field->findChild<QLineEdit*>()->setCursorPosition(9);
    std::vector<double> times;
    for (int i = 0; i < repeats; ++i) {
        // 0.1, 0.11 and back again.
        times.push_back(millisecondsToPixels(*field, i % 2 == 0 ? Qt::Key_1 : Qt::Key_Backspace, watch));
        settle(window);
    }
    printTimes(name, std::move(times));
}

// State of a page's study.
struct OnShow {
    bool isPresent = false;  // of the present scenario
    bool isWhole = false;
};
using StudyAsked = std::function<OnShow()>;

// Notices when the study of the present scenario has been painted: a first picture, then all of it.
class StudyWatch : public QObject {
  public:
    explicit StudyWatch(StudyAsked asked) : m_asked(std::move(asked)) {}
    void expect() {
        m_first.reset();
        m_whole.reset();
    }
    std::optional<Clock::time_point> first() const { return m_first; }
    std::optional<Clock::time_point> whole() const { return m_whole; }

  protected:
    bool eventFilter(QObject* /*plot*/, QEvent* event) override {
        if (event->type() != QEvent::Paint) return false;
        const OnShow state = m_asked();
        if (state.isPresent && !m_first) m_first = Clock::now();
        if (state.isPresent && state.isWhole && !m_whole) m_whole = Clock::now();
        return false;
    }

  private:
    StudyAsked m_asked;
    std::optional<Clock::time_point> m_first, m_whole;
};

// From one key to the next: a study that still runs is stopped at once by then, see Worker.
constexpr int millisecondsOfTypist = 300;

// A study page by steps of the gap in one gesture: until a first picture while the study of the step before
// still runs and has to be stopped, and `wholes` times until the whole one.
void measureDrag(MainWindow& window, PlotPage& page, const QString& name, int repeats, int wholes,
                 StudyAsked asked) {
    part<PageTabs>(window).setCurrentWidget(&page);
    settle(window);
    StudyWatch watch(std::move(asked));
    page.plot()->installEventFilter(&watch);
    const int gesture = window.document().newGesture();
    int step = 0;
    const auto measureTo = [&](const QString& what, int count, const auto& painted) {
        std::vector<double> times;
        for (int i = 0; i < count; ++i) {
            watch.expect();
            const Clock::time_point start = Clock::now();
            window.document().assign(*findParameter("bit_rock.gap"), ++step * 1e-5, gesture);
            while (!painted()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
            times.push_back(std::chrono::duration<double, std::milli>(*painted() - start).count());
            QTest::qWait(millisecondsOfTypist);
        }
        if (count > 0) printTimes(what, std::move(times));
    };
    measureTo(name + QStringLiteral(", first"), repeats, [&] { return watch.first(); });
    measureTo(name, wholes, [&] { return watch.whole(); });
}

// A map of 200 × 200 blows, coarse at first.
void measureDragOnMap(MainWindow& window, PulseShape shape, int repeats) {
    auto& page = part<MapPage>(window);
    window.document().setShape(shape);
    measureDrag(window, page, QStringLiteral("Map, %1").arg(QLatin1StringView(drillwave::name(shape))),
                repeats, repeats, [&] {
                    const FieldItem* field = page.figureFrame().field();
                    if (!field || !page.report()) return OnShow{};
                    return OnShow{page.report()->study.base == window.document().scenario(),
                                  field->field()->grid->isComplete()};
                });
}

// Starts with 256 samples, refined to the default number.
void measureDragOnDesign(MainWindow& window, const QString& what, int repeats) {
    auto& page = part<DesignPage>(window);
    // of a string bench_design tells
    const int wholes = isString(window.document().scenario()) ? 0 : repeats;
    measureDrag(window, page, QStringLiteral("Design") + what, repeats, wholes, [&] {
        const DesignAnswer* answer = page.answer();
        if (!answer) return OnShow{};
        return OnShow{answer->report.study.base == window.document().scenario() && answer->hasBest(),
                      answer->isRefined()};
    });
}

// Follows the blows as they come.
void measureDragOnDrilling(MainWindow& window, const QString& what, int repeats) {
    auto& page = part<DrillingPage>(window);
    measureDrag(window, page, QStringLiteral("Drilling") + what, repeats, repeats, [&] {
        const DrillingAnswer* answer = page.answer();
        if (!answer) return OnShow{};
        return OnShow{
            answer->question == drillingQuestion(window.document().scenario()) && !answer->blows().empty(),
            answer->isComplete()};
    });
}

// The longest time that the window let wait while a slider was dragged.
void measureTurns(MainWindow& window, const QString& name, int drags) {
    std::vector<double> times;
    for (int i = 0; i < drags; ++i) {
        const std::optional<GapWatch> gaps = test::dragStiffness(window, 20);
        if (!gaps) qFatal("the window does not follow the slider");
        times.push_back(gaps->longestWall.count());
        settle(window);
    }
    if (drags > 0) printTimes(name + QStringLiteral(", longest turn"), std::move(times));
}

void measurePages(MainWindow& window, const QString& what, int repeats) {
    auto* pages = window.findChild<PageTabs*>();
    for (int page = 0; page < pages->count(); ++page) {
        pages->setCurrentIndex(page);
        settle(window);
        const QString name = pages->page(page).title() + what;
        measurePage(window, name, repeats);
        measureTurns(window, name, repeats / 5);
    }
}

/// The longest time that the window let wait while a record of a million samples was read and identified.
void measureRecord(MainWindow& window) {
    constexpr int samples = 1000000;
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("record.csv")));
    if (!file.open(QIODevice::WriteOnly)) qFatal("no folder for a record");
    const Blow blow = solveBlow(window.document().scenario(), {}, Detail::histories);
    const std::string table = gaugeRecordCsv(blow, {{"strain", 1.83}}, 0.005, 1);
    file.write(table.data(), qint64(table.size()));
    // quiet afterwards, at the rate of the record
    std::mt19937_64 random(1);
    double time = std::stod(table.substr(table.rfind('\n', table.size() - 2) + 1));
    for (auto line = std::ranges::count(table, '\n'); line < samples; ++line)
        file.write(QByteArray::number(time += 1e6 / gaugeRecordRate) + ',' +
                   QByteArray::number(4 * standardNormal(random)) + '\n');
    file.close();
    auto* page = window.findChild<IdentifyPage*>();
    window.findChild<PageTabs*>()->setCurrentWidget(page);
    QTest::qWait(200);  // until the page is shown, without a record
    GapWatch gaps;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, page, [&gaps] { gaps.turn(); });
    timer.start(1);
    const Clock::time_point start = Clock::now();
    page->openRecord(file.fileName());
    auto* place = page->findChild<QuantityField*>(QStringLiteral("distance1"))->findChild<QLineEdit*>();
    place->selectAll();
    QTest::keyClicks(place, QStringLiteral("1.83 m"));
    QTest::keyClick(place, Qt::Key_Return);
    if (!QTest::qWaitFor([page] { return bool(page->answer()); }, 60000)) qFatal("no answer");
    std::printf("%-36s %8.1f ms, longest turn %.1f ms\n", "Identify, a million samples",
                std::chrono::duration<double, std::milli>(Clock::now() - start).count(),
                gaps.longestWall.count());
}

void measure(MainWindow& window, int repeats) {
    measureRecord(window);
    std::printf("%-36s %8s %8s %8s  ms from keystroke to pixels\n", "page", "median", "minimum", "maximum");
    measurePages(window, QString(), repeats);
    for (const PulseShape shape : {PulseShape::rectangular, PulseShape::halfSine})
        measureDragOnMap(window, shape, repeats);
    measureDragOnDesign(window, QString(), repeats);
    measureDragOnDrilling(window, QString(), repeats);
    window.openExample(*findExample("t38_string"));  // a hammer of three sections, eleven of the string
    // the note on an example takes other room once it has been changed: that is not of every keystroke
    window.document().assign(*findParameter("drill.thrust"), 9000, window.document().newGesture());
    measurePages(window, QStringLiteral(", string"), repeats);
    measureDragOnDesign(window, QStringLiteral(", string"), repeats);
    measureDragOnDrilling(window, QStringLiteral(", string"), repeats);
}

}  // namespace

int main(int argc, char** argv) {
    return test::benchWindow(argc, argv, "bench_window", "REPEATS", 50, measure);
}
