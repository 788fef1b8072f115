// SPDX-License-Identifier: GPL-3.0-or-later
// Chunks worked on by several threads come out in order, whatever the threads do.
#include <QTest>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/numeric/ordered_work.h"
#include "core/study/rows/shard.h"

using namespace drillwave;

namespace {

struct Chunk {
    int number = 0;
    int result = 0;
};

/// Fills chunks 0 … count − 1.
auto countingTo(int count) {
    return [next = 0, count](Chunk& chunk) mutable {
        chunk.number = next++;
        return chunk.number < count;
    };
}

/// Squares the number; the first chunks take longest, so that they would come last if nothing kept the order.
auto slowSquares() {
    return [](Chunk& chunk, std::stop_token) {
        std::this_thread::sleep_for(
            std::chrono::microseconds(chunk.number < 4 ? 3000 : chunk.number % 5 * 50));
        chunk.result = chunk.number * chunk.number;
    };
}

}  // namespace

class TestOrderedRows : public QObject {
    Q_OBJECT

  private slots:
    void chunksComeOutInOrder_data();
    void chunksComeOutInOrder();
    void nothingToDoEndsAtOnce();
    void noMoreChunksThanFourForEachThreadAreInWork();
    void aStopEndsTheRunBeforeItsEnd();
    void aStopThatCameBeforeTheStartLetsNothingThrough();
    void deliveringFalseEndsTheRun();
    void exceptionsOfAnyPartReachTheCaller_data();
    void exceptionsOfAnyPartReachTheCaller();
    void shardsPutTogetherAreTheWhole();
};

void TestOrderedRows::chunksComeOutInOrder_data() {
    QTest::addColumn<int>("jobs");
    for (const int jobs : {1, 2, 3, 8}) QTest::addRow("%d threads", jobs) << jobs;
}

void TestOrderedRows::chunksComeOutInOrder() {
    QFETCH(int, jobs);
    std::vector<int> delivered;
    const WorkEnd end = processInOrder<Chunk>(jobs, {}, countingTo(100), slowSquares, [&](Chunk& chunk) {
        delivered.push_back(chunk.result);
        return true;
    });
    QCOMPARE(end, WorkEnd::finished);
    QCOMPARE(delivered.size(), std::size_t{100});
    for (int i = 0; i < 100; ++i) QCOMPARE(delivered[static_cast<std::size_t>(i)], i * i);
}

void TestOrderedRows::nothingToDoEndsAtOnce() {
    const WorkEnd end = processInOrder<Chunk>(4, {}, countingTo(0), slowSquares, [](Chunk&) { return true; });
    QCOMPARE(end, WorkEnd::finished);
}

void TestOrderedRows::noMoreChunksThanFourForEachThreadAreInWork() {
    std::atomic<int> filled = 0;
    int delivered = 0;
    int most = 0;
    const auto fill = [&](Chunk&) { return ++filled <= 200; };
    processInOrder<Chunk>(2, {}, fill, slowSquares, [&](Chunk&) {
        // A slow reader: the workers run ahead as far as they may.
        std::this_thread::sleep_for(std::chrono::microseconds(300));
        most = std::max(most, filled.load() - delivered);
        ++delivered;
        return true;
    });
    QCOMPARE(delivered, 200);
    QVERIFY2(most <= 2 * 4, qPrintable(QString::number(most)));
}

void TestOrderedRows::aStopEndsTheRunBeforeItsEnd() {
    std::stop_source source;
    int delivered = 0;
    const auto endless = [](Chunk&) { return true; };
    const WorkEnd end = processInOrder<Chunk>(3, source.get_token(), endless, slowSquares, [&](Chunk&) {
        if (++delivered == 10) source.request_stop();
        return true;
    });
    QCOMPARE(end, WorkEnd::stopped);
    QCOMPARE(delivered, 10);
}

void TestOrderedRows::aStopThatCameBeforeTheStartLetsNothingThrough() {
    std::stop_source source;
    source.request_stop();
    const WorkEnd end = processInOrder<Chunk>(2, source.get_token(), countingTo(10), slowSquares, [](Chunk&) {
        qFatal("delivered after a stop");
        return true;
    });
    QCOMPARE(end, WorkEnd::stopped);
}

void TestOrderedRows::deliveringFalseEndsTheRun() {
    int delivered = 0;
    const auto endless = [](Chunk&) { return true; };
    const WorkEnd end =
        processInOrder<Chunk>(2, {}, endless, slowSquares, [&](Chunk&) { return ++delivered < 5; });
    QCOMPARE(end, WorkEnd::stopped);
    QCOMPARE(delivered, 5);
}

void TestOrderedRows::exceptionsOfAnyPartReachTheCaller_data() {
    QTest::addColumn<QString>("part");
    for (const char* part : {"fill", "make", "work", "deliver"}) QTest::newRow(part) << part;
}

void TestOrderedRows::exceptionsOfAnyPartReachTheCaller() {
    QFETCH(QString, part);
    const auto failIn = [&](const char* place) {
        if (part == place) throw std::runtime_error(place);
    };
    std::atomic<int> filled = 0;
    const auto fill = [&](Chunk&) {
        if (++filled == 20) failIn("fill");
        return filled < 1000;
    };
    const auto makeWorker = [&] {
        failIn("make");
        return [&](Chunk&, std::stop_token) {
            if (filled >= 20) failIn("work");
        };
    };
    const auto deliver = [&](Chunk&) {
        failIn("deliver");
        return true;
    };
    QString caught;
    try {
        processInOrder<Chunk>(3, {}, fill, makeWorker, deliver);
    } catch (const std::runtime_error& error) {
        caught = error.what();
    }
    QCOMPARE(caught, part);
}

void TestOrderedRows::shardsPutTogetherAreTheWhole() {
    for (const std::uint64_t rows : {0ULL, 1ULL, 2ULL, 7ULL, 1000ULL, 1'000'000'000'000ULL})
        for (const std::uint64_t count : {1ULL, 2ULL, 3ULL, 7ULL, 999'983ULL}) {
            std::uint64_t next = 0;
            for (std::uint64_t index = 1; index <= count; ++index) {
                const RowRange part = rowsOf({index, count}, rows);
                QCOMPARE(part.begin, next);
                QVERIFY(part.size() == rows / count || part.size() == rows / count + 1);
                next = part.end;
            }
            QCOMPARE(next, rows);
        }
}

QTEST_GUILESS_MAIN(TestOrderedRows)
#include "tst_ordered_work.moc"
