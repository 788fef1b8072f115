// SPDX-License-Identifier: GPL-3.0-or-later
// The waves inside the rod keep their order and their values, and what is known of a piece follows its
// changes.
#include "core/wave/exact/contact_march_state.h"

#include <QTest>
#include <algorithm>
#include <deque>
#include <random>

#include "core/wave/exact/series_joiner.h"
#include "tests/support/series.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

bool waysAreRight(const WavePiece<double>& f) {
    const auto& way = f.way();
    return way.whole == f.integral(f.length) && way.most == f.mostIntegral() &&
           way.size == f.integralOfSizes();
}

}  // namespace

class TestWaveQueue : public QObject {
    Q_OBJECT

  private slots:
    // Against a queue of values, over many rounds: the ring grows, turns, and gives places out again.
    void piecesKeepTheirOrderAndValues() {
        std::mt19937 random(3);
        WaveQueue<int> queue;
        std::deque<int> expected;
        int next = 0, taken = -1;
        for (int step = 0; step < 100'000; ++step) {
            const unsigned what = random() % 8;
            if (what < 3 || expected.empty()) {
                queue.pushBack(++next);
                expected.push_back(next);
            } else if (what < 5) {
                taken = expected.front();
                expected.pop_front();
                QCOMPARE(queue.take(), taken);
            } else if (what == 5) {
                queue.popFront();
                expected.pop_front();
            } else if (what == 6) {
                queue.popBack();
                expected.pop_back();
            } else {
                const std::size_t count = random() % expected.size();
                queue.rotate(count);
                std::rotate(expected.begin(), expected.begin() + std::ptrdiff_t(count), expected.end());
            }
            QCOMPARE(queue.size(), expected.size());
            if (taken >= 0) QCOMPARE(queue.taken(), taken);  // whatever has been put in since
            if (expected.empty()) continue;
            const std::size_t i = random() % expected.size();
            QCOMPARE(queue[i], expected[i]);
            QCOMPARE(queue.front(), expected.front());
            QCOMPARE(queue.back(), expected.back());
        }
        QVERIFY(next > 30'000);
    }

    void theWayOfAPieceFollowsItsChanges() {
        WavePiece<double> f = series(2, {1, -3, 2, 0.5});
        QVERIFY(waysAreRight(f));
        f.shorten(1.5);
        QVERIFY(waysAreRight(f));
        f.dropFront(0.25);
        QVERIFY(waysAreRight(f));
        WavePiece<double> copy = f;
        QVERIFY(waysAreRight(copy));
        copy.c[0] += 1;
        copy.forgetWay();
        QVERIFY(waysAreRight(copy));
        QVERIFY(copy.way().whole != f.way().whole);
    }
};

QTEST_GUILESS_MAIN(TestWaveQueue)
#include "tst_wave_queue.moc"
