// SPDX-License-Identifier: GPL-3.0-or-later
// Memory of the process while windows are opened, each with an example that is solved and drawn, and closed
// again: bench_opening [CYCLES], 100 by default. Run by ctest with few, to see that it runs: memory depends
// on the machine.
#include <malloc.h>
#include <QElapsedTimer>
#include <QPixmapCache>
#include <QTest>
#include <cstdio>

#include "core/yaml/examples.h"
#include "tests/bench/bench_program.h"
#include "tests/support/window_parts.h"
#include "ui/window/page_tabs.h"

using namespace drillwave;

namespace {

// Returns the allocated memory, without the reserves of the allocator.
double megabytesInUse() {
    const auto found = ::mallinfo2();
    return double(found.uordblks + found.hblkhd) / 1e6;
}

void cycle(int number) {
    const std::span<const Example> examples = builtInExamples();
    MainWindow window;
    window.resize(1440, 900);
    window.show();
    window.openExample(examples[static_cast<std::size_t>(number) % examples.size()]);
    auto& pages = part<PageTabs>(window);
    pages.setCurrentIndex(number % pages.count());
    QTest::qWait(30);
    window.close();
}

void measure(MainWindow& /*window*/, int cycles) {
    constexpr int parts = 8;
    // Qt's cache keeps up to 10 MB of pictures, and of each it ever had its name, cleared or not: in each
    // window those on the buttons of its docks, a kilobyte.
    QPixmapCache::setCacheLimit(0);
    std::printf("cycles   MB in use   MB resident   ms a cycle\n");
    cycle(0);
    std::printf("%6d %11.3f %13.1f\n", 1, megabytesInUse(), test::megabytes());
    int done = 1;
    for (int part = 1; part <= parts; ++part) {
        QElapsedTimer timer;
        timer.start();
        const int before = done;
        for (; done < cycles * part / parts; ++done) cycle(done);
        if (done > before)
            std::printf("%6d %11.3f %13.1f %12.1f\n", done, megabytesInUse(), test::megabytes(),
                        double(timer.elapsed()) / (done - before));
        std::fflush(stdout);
    }
}

}  // namespace

int main(int argc, char** argv) {
    return test::benchWindow(argc, argv, "bench_opening", "CYCLES", 100, measure);
}
