// SPDX-License-Identifier: GPL-3.0-or-later
// Studies as the pages will have them: coarse values first, then fine ones, replaced while they run. Gates
// hold them where a test wants them.
#include <QSignalSpy>
#include <QTest>
#include <atomic>
#include <semaphore>
#include <stdexcept>
#include <thread>
#include <vector>

#include "ui/job/study_job.h"

#ifdef Q_OS_LINUX
#include <sys/resource.h>
#endif

using namespace drillwave;

namespace {

/// The points of a curve found so far, and for what it is.
struct Curve {
    int parameter = 0;
    std::vector<double> points;
};

using CurveJob = StudyJob<Curve>;
using Gate = std::binary_semaphore;

Curve coarse(int parameter) {
    return {parameter, {1, 3}};
}

Curve fine(int parameter) {
    return {parameter, {1, 2, 3}};
}

void untilStopped(const std::stop_token& stop) {
    while (!stop.stop_requested()) std::this_thread::yield();
}

}  // namespace

class TestStudyJob : public QObject {
    Q_OBJECT

  private slots:
    void coarseValuesComeBeforeFineOnes();
    void everythingArrivesOnTheWindowsThread();
    void theLastOfManyStudiesWins();
    void theValueOfAnEarlierStudyStaysUntilThereIsAnother();
    void whatAnEarlierStudyShowsIsNotCurrent();
    void aCancelledStudyKeepsWhatItHasShown();
    void aStudyStopsWhenItsTimeIsOverUnlessItIsResumed();
    void aStudyResumedEarlyHasNoTimeLimit();
    void aStudyAfterACancelGetsItsValue();
    void whatAStudyThrowsIsItsProblem();
    void aLongStudyIsStoppedWhenANewerOneWaits();
    void manyValuesAtOnceAreOneChange();
    void progressComesFromAnyThreadOfAStudy();
    void aJobEndsInTheMiddleOfAStudy();
    void aStudyAndItsThreadsYieldToTheWindow();
};

void TestStudyJob::coarseValuesComeBeforeFineOnes() {
    Gate gate{0};
    CurveJob job;
    QCOMPARE(job.state(), StudyState::idle);
    QVERIFY(!job.value());
    job.submit([&gate](const StudyFeed<Curve>& feed) {
        feed.show(coarse(1));
        feed.tell({2, 3});
        gate.acquire();
        return fine(1);
    });
    QCOMPARE(job.state(), StudyState::running);
    QTRY_COMPARE(job.progress(), (StudyProgress{2, 3}));
    QCOMPARE(job.value()->points, coarse(1).points);
    QVERIFY(job.isCurrent());
    QCOMPARE(job.state(), StudyState::running);
    gate.release();
    QTRY_COMPARE(job.state(), StudyState::finished);
    QCOMPARE(job.value()->points, fine(1).points);
    QCOMPARE(job.problem(), QString());
}

void TestStudyJob::everythingArrivesOnTheWindowsThread() {
    CurveJob job;
    std::vector<std::thread::id> heardOn;
    connect(
        &job, &StudyActivity::changed, &job, [&] { heardOn.push_back(std::this_thread::get_id()); },
        Qt::DirectConnection);
    std::atomic<std::thread::id> studiedOn;
    job.submit([&studiedOn](const StudyFeed<Curve>& feed) {
        studiedOn = std::this_thread::get_id();
        feed.show(coarse(1));
        return fine(1);
    });
    QTRY_COMPARE(job.state(), StudyState::finished);
    QVERIFY(studiedOn.load() != std::this_thread::get_id());
    QVERIFY(heardOn.size() >= 2);  // running, and finished
    for (const std::thread::id& thread : heardOn) QVERIFY(thread == std::this_thread::get_id());
}

void TestStudyJob::theLastOfManyStudiesWins() {
    Gate gate{0};
    CurveJob job;
    std::atomic<int> calls = 0;
    std::vector<int> seen;
    connect(&job, &StudyActivity::changed, this, [&] {
        if (job.value() && (seen.empty() || seen.back() != job.value()->parameter))
            seen.push_back(job.value()->parameter);
    });
    for (int parameter = 1; parameter <= 20; ++parameter)
        job.submit([&, parameter](const StudyFeed<Curve>&) {
            ++calls;
            if (parameter == 1) gate.acquire();
            return fine(parameter);
        });
    gate.release();
    QTRY_COMPARE(job.state(), StudyState::finished);
    QCOMPARE(job.value()->parameter, 20);
    QCOMPARE(calls.load(), 2);
    QVERIFY(std::is_sorted(seen.begin(), seen.end()));
}

void TestStudyJob::theValueOfAnEarlierStudyStaysUntilThereIsAnother() {
    Gate gate{0};
    CurveJob job;
    job.submit([](const StudyFeed<Curve>&) { return fine(1); });
    QTRY_COMPARE(job.state(), StudyState::finished);
    job.submit([&gate](const StudyFeed<Curve>& feed) {
        feed.tell({0, 3});
        gate.acquire();
        feed.show(coarse(2));
        gate.acquire();
        return fine(2);
    });
    QTRY_COMPARE(job.progress(), (StudyProgress{0, 3}));
    QCOMPARE(job.value()->parameter, 1);
    QVERIFY(!job.isCurrent());
    gate.release();
    QTRY_VERIFY(job.isCurrent());
    QCOMPARE(job.value()->points, coarse(2).points);
    gate.release();
    QTRY_COMPARE(job.state(), StudyState::finished);
}

// While values are dragged the curve follows, though every study is behind the hand.
void TestStudyJob::whatAnEarlierStudyShowsIsNotCurrent() {
    Gate gate{0};
    CurveJob job;
    job.submit([&gate](const StudyFeed<Curve>& feed) {
        gate.acquire();
        feed.tell({1, 3});
        feed.show(coarse(1));
        gate.acquire();
        return fine(1);
    });
    job.submit([](const StudyFeed<Curve>&) { return fine(2); });
    gate.release();
    QTRY_VERIFY(job.value());
    QCOMPARE(job.value()->parameter, 1);
    QVERIFY(!job.isCurrent());
    QCOMPARE(job.state(), StudyState::running);
    QCOMPARE(job.progress(), StudyProgress());  // that of the study that waits
    gate.release();
    QTRY_COMPARE(job.state(), StudyState::finished);
    QCOMPARE(job.value()->parameter, 2);
    QVERIFY(job.isCurrent());
}

void TestStudyJob::aCancelledStudyKeepsWhatItHasShown() {
    CurveJob job;
    std::atomic<bool> ended = false;
    job.submit([&ended](const StudyFeed<Curve>& feed) {
        feed.show(coarse(1));
        untilStopped(feed.stop);
        feed.show({-1, {}});
        ended = true;
        return Curve{-2, {}};
    });
    QTRY_VERIFY(job.value());
    job.cancel();
    QCOMPARE(job.state(), StudyState::stopped);
    while (!ended) std::this_thread::yield();
    // The next value in the queue of events shows that nothing came before.
    std::vector<int> seen;
    connect(&job, &StudyActivity::changed, this, [&] { seen.push_back(job.value()->parameter); });
    job.submit([](const StudyFeed<Curve>&) { return fine(2); });
    QTRY_COMPARE(job.state(), StudyState::finished);
    QCOMPARE(seen.front(), 1);
    QCOMPARE(seen.back(), 2);
    QVERIFY(std::is_sorted(seen.begin(), seen.end()));
    job.cancel();  // there is nothing to stop
    QCOMPARE(job.state(), StudyState::finished);
}

void TestStudyJob::aStudyStopsWhenItsTimeIsOverUnlessItIsResumed() {
    CurveJob job;
    job.setTimeLimit(std::chrono::milliseconds(20));
    std::atomic<int> runs = 0;
    job.submit([&runs](const StudyFeed<Curve>& feed) {
        feed.show(coarse(1));
        if (++runs == 1) untilStopped(feed.stop);
        QTest::qSleep(60);  // longer than the time limit
        return fine(1);
    });
    QTRY_COMPARE(job.state(), StudyState::stopped);
    QVERIFY(job.isOutOfTime());
    QVERIFY(job.value());
    job.resume();
    QTRY_COMPARE(job.state(), StudyState::finished);
    QCOMPARE(runs.load(), 2);
    job.resume();  // there is nothing to resume
    QCOMPARE(job.state(), StudyState::finished);
    // The next one has its time again, and a user who stops it did not wait for its end.
    job.submit([](const StudyFeed<Curve>& feed) {
        untilStopped(feed.stop);
        return fine(2);
    });
    QVERIFY(!job.isOutOfTime());
    job.cancel();
    QVERIFY(!job.isOutOfTime());
}

/// Cancelled before its time is over and resumed: what was left of the time does not count any more.
void TestStudyJob::aStudyResumedEarlyHasNoTimeLimit() {
    CurveJob job;
    job.setTimeLimit(std::chrono::milliseconds(200));
    std::atomic<int> runs = 0;
    job.submit([&runs](const StudyFeed<Curve>& feed) {
        if (++runs == 1) untilStopped(feed.stop);
        QTest::qSleep(400);  // longer than what is left of the time
        return fine(1);
    });
    QTRY_COMPARE(runs.load(), 1);
    job.cancel();
    job.resume();
    QTRY_COMPARE(job.state(), StudyState::finished);
    QCOMPARE(runs.load(), 2);
}

void TestStudyJob::aStudyAfterACancelGetsItsValue() {
    CurveJob job;
    job.submit([](const StudyFeed<Curve>& feed) {
        untilStopped(feed.stop);
        return fine(1);
    });
    job.cancel();
    job.submit([](const StudyFeed<Curve>&) { return fine(2); });
    QCOMPARE(job.state(), StudyState::running);
    QTRY_COMPARE(job.state(), StudyState::finished);
    QCOMPARE(job.value()->parameter, 2);
}

void TestStudyJob::whatAStudyThrowsIsItsProblem() {
    CurveJob job;
    job.submit([](const StudyFeed<Curve>& feed) -> Curve {
        feed.show(coarse(1));
        throw std::runtime_error("no rock so stiff");
    });
    QTRY_COMPARE(job.state(), StudyState::failed);
    QCOMPARE(job.problem(), QStringLiteral("no rock so stiff"));
    QCOMPARE(job.value()->points, coarse(1).points);
    job.submit([](const StudyFeed<Curve>&) -> Curve { throw 1; });
    QCOMPARE(job.problem(), QString());
    QTRY_COMPARE(job.state(), StudyState::failed);
    QVERIFY(!job.problem().isEmpty());
}

void TestStudyJob::aLongStudyIsStoppedWhenANewerOneWaits() {
    CurveJob job;
    std::atomic<int> stopped = 0;
    const auto endless = [&stopped](const StudyFeed<Curve>& feed) {
        untilStopped(feed.stop);
        ++stopped;
        return Curve{-1, {}};
    };
    std::vector<int> seen;
    connect(&job, &StudyActivity::changed, this, [&] {
        if (job.value()) seen.push_back(job.value()->parameter);
    });
    job.submit(endless);
    job.submit(endless);
    job.submit([](const StudyFeed<Curve>&) { return fine(3); });
    QTRY_COMPARE(job.state(), StudyState::finished);
    QCOMPARE(stopped.load(), 1);
    QCOMPARE(seen, std::vector<int>{3});
}

void TestStudyJob::manyValuesAtOnceAreOneChange() {
    Gate flooded{0}, gate{0};
    CurveJob job;
    job.submit([&](const StudyFeed<Curve>& feed) {
        for (int i = 0; i < 10000; ++i) feed.show({i, {}});
        feed.tell({10000, 10000});
        flooded.release();
        gate.acquire();
        return fine(10000);
    });
    flooded.acquire();  // the window is busy meanwhile
    QSignalSpy changed(&job, &StudyActivity::changed);
    QTRY_VERIFY(job.value());
    QCOMPARE(job.value()->parameter, 9999);
    QCOMPARE(job.progress(), (StudyProgress{10000, 10000}));
    QCOMPARE(changed.count(), 1);
    gate.release();
    QTRY_COMPARE(job.state(), StudyState::finished);
    QCOMPARE(changed.count(), 2);
}

void TestStudyJob::progressComesFromAnyThreadOfAStudy() {
    constexpr std::size_t each = 500;
    CurveJob job;
    job.submit([](const StudyFeed<Curve>& feed) {
        std::atomic<std::size_t> done = 0;
        const auto work = [&] {
            for (std::size_t i = 0; i < each; ++i) feed.tell({++done, 2 * each});
        };
        { const std::jthread one(work), other(work); }
        feed.tell({done, 2 * each});
        return fine(1);
    });
    QTRY_COMPARE(job.state(), StudyState::finished);
    QCOMPARE(job.progress(), (StudyProgress{2 * each, 2 * each}));
}

void TestStudyJob::aJobEndsInTheMiddleOfAStudy() {
    Gate begun{0};
    std::atomic<bool> ended = false;
    {
        CurveJob job;
        job.submit([&](const StudyFeed<Curve>& feed) {
            feed.show(coarse(1));
            begun.release();
            untilStopped(feed.stop);
            feed.show(coarse(1));
            ended = true;
            return fine(1);
        });
        begun.acquire();
    }
    QVERIFY(ended);
}

void TestStudyJob::aStudyAndItsThreadsYieldToTheWindow() {
#ifdef Q_OS_LINUX
    const auto niceness = [] { return getpriority(PRIO_PROCESS, 0); };
    const int ofWindow = niceness();
    if (ofWindow > 14) QSKIP("there is no nicer thread than these");
    int ofStudy = ofWindow, ofItsThread = ofWindow;
    CurveJob job;
    job.submit([&](const StudyFeed<Curve>&) {
        ofStudy = niceness();
        std::jthread([&] { ofItsThread = niceness(); }).join();
        return fine(1);
    });
    QTRY_COMPARE(job.state(), StudyState::finished);
    QVERIFY(ofStudy > ofWindow);
    QCOMPARE(ofItsThread, ofStudy);
    QCOMPARE(niceness(), ofWindow);
#else
    QSKIP("Linux keeps a niceness for each thread");
#endif
}

QTEST_GUILESS_MAIN(TestStudyJob)
#include "tst_study_job.moc"
