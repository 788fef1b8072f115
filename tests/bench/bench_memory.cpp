// SPDX-License-Identifier: GPL-3.0-or-later
// Memory of the process while values change with each study in view: bench_memory [CHANGES], 20000 in all by
// default. Not run by ctest but for a trial: memory depends on the machine.
#include <QTest>
#include <cmath>
#include <cstdio>

#include "tests/bench/bench_program.h"
#include "tests/support/window_parts.h"
#include "ui/window/page_tabs.h"

using namespace drillwave;

namespace {

// The gap goes up and down, each time as a step of its own to undo.
void change(MainWindow& window, int count) {
    for (int i = 0; i < count; ++i) {
        const double wave = 0.5 - 0.5 * std::cos(i * 0.01);
        Document& document = window.document();
        document.assign(*findParameter("bit_rock.gap"), 1e-3 * wave, document.newGesture());
        QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
        QTest::qWait(1);
    }
}

void measure(MainWindow& window, int changes) {
    auto& pages = part<PageTabs>(window);
    constexpr int parts = 4;
    const int share = std::max(1, changes / (pages.count() * parts));
    std::printf("%-16s  MB resident, at first and after each %d changes\n", "page", share);
    for (int page = 0; page < pages.count(); ++page) {
        pages.setCurrentIndex(page);
        QTest::qWait(200);
        std::printf("%-16s %6.1f", qPrintable(pages.page(page).title()), test::megabytes());
        for (int n = 0; n < parts; ++n) {
            change(window, share);
            std::printf(" %6.1f", test::megabytes());
            std::fflush(stdout);
        }
        std::printf("\n");
    }
}

}  // namespace

int main(int argc, char** argv) {
    return test::benchWindow(argc, argv, "bench_memory", "CHANGES", 20000, measure);
}
