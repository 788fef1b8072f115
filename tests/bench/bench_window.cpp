// SPDX-License-Identifier: GPL-3.0-or-later
// Milliseconds from a keystroke in a field to the new pixels of the whole window, page by page, of a rod and
// of a drill string, and from a step of a slider to those of a new map, coarse and whole:
// bench_window [REPEATS], 50 by default. Not run by ctest but for a trial: times depend on the machine.
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <algorithm>
#include <chrono>
#include <cstdio>

#include "core/yaml/examples.h"
#include "tests/bench/bench_program.h"
#include "tests/support/window_parts.h"
#include "ui/form/quantity_field.h"
#include "ui/form/scenario_panel.h"
#include "ui/job/solve_job.h"
#include "ui/pages/gap/gap_page.h"
#include "ui/pages/map/map_page.h"
#include "ui/pages/map/map_plot.h"
#include "ui/pages/plot_page.h"
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
    std::printf("%-30s %8.1f %8.1f %8.1f\n", qPrintable(name), times[times.size() / 2], times.front(),
                times.back());
}

void measurePage(MainWindow& window, const QString& name, int repeats) {
    auto* page = qobject_cast<PlotPage*>(window.findChild<PageTabs*>()->currentWidget());
    if (!page) return;  // a table
    // of a string it tells in words that there is nothing to draw
    if (qobject_cast<GapPage*>(page) && isString(window.document().scenario())) return;
    PaintWatch watch(window);
    page->plot()->installEventFilter(&watch);
    // Where the plot does not depend on the field, as a map does not on its own parameters, words do.
    if (auto* words = page->findChild<QLabel*>(QStringLiteral("words"))) words->installEventFilter(&watch);
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

// Notices when the map of the present scenario has been painted: coarse at first, then all of it.
class MapWatch : public QObject {
  public:
    MapWatch(MainWindow& window, MapPage& page) : m_window(window), m_page(page) {}
    bool isPainted() const { return m_painted; }
    /// When any picture was.
    Clock::time_point first() const { return *m_first; }
    void expect() {
        m_first.reset();
        m_painted = false;
    }

  protected:
    bool eventFilter(QObject* /*plot*/, QEvent* event) override {
        const std::optional<MapPicture>& picture = m_page.map()->picture();
        if (event->type() != QEvent::Paint || !picture ||
            picture->report->study.base != m_window.document().scenario())
            return false;
        if (!m_first) m_first = Clock::now();
        m_painted = picture->grid().isComplete();
        return false;
    }

  private:
    MainWindow& m_window;
    MapPage& m_page;
    std::optional<Clock::time_point> m_first;
    bool m_painted = false;
};

// The gap, which is on neither axis, in steps of one gesture: a map of 200 × 200 blows each.
void measureDragOnMap(MainWindow& window, PulseShape shape, int repeats) {
    auto& page = part<MapPage>(window);
    part<PageTabs>(window).setCurrentWidget(&page);
    window.document().setShape(shape);
    settle(window);
    MapWatch watch(window, page);
    page.plot()->installEventFilter(&watch);
    const int gesture = window.document().newGesture();
    std::vector<double> firsts, times;
    for (int i = 0; i < repeats; ++i) {
        watch.expect();
        const Clock::time_point start = Clock::now();
        window.document().assign(*findParameter("bit_rock.gap"), (i + 1) * 1e-5, gesture);
        while (!watch.isPainted()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        const auto since = [start](Clock::time_point time) {
            return std::chrono::duration<double, std::milli>(time - start).count();
        };
        firsts.push_back(since(watch.first()));
        times.push_back(since(Clock::now()));
    }
    const QString name = QStringLiteral("Map, %1").arg(QLatin1StringView(drillwave::name(shape)));
    printTimes(name + QStringLiteral(", first"), std::move(firsts));
    printTimes(name, std::move(times));
}

void measurePages(MainWindow& window, const QString& what, int repeats) {
    auto* pages = window.findChild<PageTabs*>();
    for (int page = 0; page < pages->count(); ++page) {
        pages->setCurrentIndex(page);
        settle(window);
        measurePage(window, pages->page(page).title() + what, repeats);
    }
}

void measure(MainWindow& window, int repeats) {
    std::printf("%-30s %8s %8s %8s  ms from keystroke to pixels\n", "page", "median", "minimum", "maximum");
    measurePages(window, QString(), repeats);
    for (const PulseShape shape : {PulseShape::rectangular, PulseShape::halfSine})
        measureDragOnMap(window, shape, repeats);
    window.openExample(*findExample("t38_string"));  // a hammer of three sections, eleven of the string
    // the note on an example takes other room once it has been changed: that is not of every keystroke
    window.document().assign(*findParameter("drill.thrust"), 9000, window.document().newGesture());
    measurePages(window, QStringLiteral(", string"), repeats);
}

}  // namespace

int main(int argc, char** argv) {
    return test::benchWindow(argc, argv, "bench_window", "REPEATS", 50, measure);
}
