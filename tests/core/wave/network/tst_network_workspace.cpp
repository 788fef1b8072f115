// SPDX-License-Identifier: GPL-3.0-or-later
// One blow after another on drill strings: no memory is asked for, and nothing of a blow is left to the next.
#include <QTest>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <new>

#include "core/wave/network/network_solver.h"
#include "core/wave/problem.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "tests/support/network_scenes.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

long allocations = 0;
std::size_t bytesHeld = 0;
constexpr std::size_t sizeOfSize = alignof(std::max_align_t);  ///< in front of what is given away

Problem t38() {
    return problemOf(parseScenario(findExample("t38_string")->text, "t38_string").scenario);
}

/// As t38(), with couplings that are lumped masses, a mass at the bit, and faces with a stiffness.
Problem withMasses() {
    Problem problem = t38();
    for (std::size_t j = problem.hammerSections(); j < problem.sections.size(); ++j)
        problem.sections[j].massAfter = 0.2;
    hammerOf(problem).face.stiffness = 5;
    return problem;
}

Problem withLosses() {
    Problem problem = t38();
    for (std::size_t j = problem.hammerSections(); j < problem.sections.size(); ++j) {
        problem.sections[j].decay = 0.01;
        if (j + 1 < problem.sections.size()) problem.sections[j].loss = 0.02;
    }
    return problem;
}

/// Only the hammer, a rod and the bit of it.
Problem withFewSections() {
    Problem problem = t38();
    problem.sections.resize(problem.hammerSections() + 2);
    return problem;
}

/// Lengths of which none is a multiple of the same.
Problem withOddLengths() {
    Problem problem = t38();
    for (std::size_t j = 0; j < problem.sections.size(); ++j)
        problem.sections[j].transitTime *= 1 + 1e-5 * std::sqrt(static_cast<double>(2 + j));
    return problem;
}

NetworkSettings settingsOf(NetworkAccuracy accuracy) {
    return {.accuracy = accuracy, .wants = {}};
}

void compareSums(const Impact& impact, const Impact& expected) {
    QCOMPARE(impact.outcome, expected.outcome);
    QCOMPARE(impact.pieces, expected.pieces);
    const auto numbers = [](const Impact& from) {
        return std::vector<double>{from.endTime,
                                   from.efficiency(),
                                   (from.hammerEnergy / from.hammerWork),
                                   (from.finalEnergy / from.hammerWork),
                                   (from.jointLoss / from.hammerWork),
                                   (from.rodLoss / from.hammerWork),
                                   (from.faceEnergy / from.hammerWork),
                                   from.efficiencyError,
                                   from.corError,
                                   from.impulse,
                                   from.hammerMomentum,
                                   from.finalMomentum,
                                   from.peakForce,
                                   from.peakTime,
                                   from.separationTime,
                                   from.faceSeparation,
                                   from.faceImpulse};
    };
    QCOMPARE(numbers(impact), numbers(expected));
}

}  // namespace

void* operator new(std::size_t size) {
    ++allocations;
    bytesHeld += size;
    auto* memory = static_cast<char*>(std::malloc(size + sizeOfSize));
    if (!memory) throw std::bad_alloc();
    std::memcpy(memory, &size, sizeof size);
    return memory + sizeOfSize;
}
void operator delete(void* memory) noexcept {
    if (!memory) return;
    char* start = static_cast<char*>(memory) - sizeOfSize;
    std::size_t size = 0;
    std::memcpy(&size, start, sizeof size);
    bytesHeld -= size;
    std::free(start);
}
void operator delete(void* memory, std::size_t) noexcept {
    operator delete(memory);
}

class TestNetworkWorkspace : public QObject {
    Q_OBJECT

  private slots:
    void aBlowOnTheSameStringAllocatesNothing_data() { strings(); }
    void aBlowOnTheSameStringAllocatesNothing() {
        QFETCH(int, string);
        QFETCH(int, accuracy);
        const Problem problem = problems().at(std::size_t(string));
        NetworkSolver solver;
        const NetworkSettings settings = settingsOf(NetworkAccuracy(accuracy));
        const Impact first = solver.solve(problem, settings);
        QVERIFY(first.outcome != Outcome::notSolved);
        const long before = allocations;
        const Impact second = solver.solve(problem, settings);
        QCOMPARE(allocations - before, 0);
        compareSums(second, first);
    }

    /// Nor do strings that were met before, whatever came between.
    void stringsThatTakeTurnsAllocateNothing() {
        const NetworkSettings settings = settingsOf(NetworkAccuracy::quick);
        NetworkSolver solver;
        for (const Problem& problem : problems()) solver.solve(problem, settings);
        const std::vector<Problem> again = problems();
        const long before = allocations;
        for (const Problem& problem : again) solver.solve(problem, settings);
        QCOMPARE(allocations - before, 0);
    }

    void solverStateIsResetBetweenBlows() {
        NetworkSolver solver;
        NetworkSettings everything;
        everything.accuracy = NetworkAccuracy::quick;
        everything.wants.events = everything.wants.forces = everything.wants.histories = true;
        const NetworkSettings settings = settingsOf(NetworkAccuracy::quick);
        NetworkSettings few = settings;
        few.mostCells = 5000;  // other cells
        std::stop_source stopped;
        stopped.request_stop();
        for (const Problem& problem : problems()) {
            const Impact alone = solveNetwork(problem, settings);
            compareSums(solver.solve(problem, settings), alone);
            solver.solve(problem, few);
            QCOMPARE(solver.solve(problem, settings, stopped.get_token()).reason.text(),
                     std::string("stopped"));
            const Impact told = solver.solve(problem, everything);
            QVERIFY(!told.events.empty() && !told.sections.empty());
            const Impact sums = solver.solve(problem, settings);
            compareSums(sums, alone);
            QVERIFY(sums.events.empty() && sums.sections.empty() && !sums.waves);
        }
    }

    void memoryIsReleasedAfterLongString() {
        Problem problem = t38();
        problem.sections.back().transitTime *= 100'000;
        problem.law.beta = 1e-3;  // cells in one part
        problem.endTime = 1;
        NetworkSolver solver;
        const std::size_t before = bytesHeld;
        const Impact impact = solver.solve(problem, settingsOf(NetworkAccuracy::quick));
        QCOMPARE(impact.outcome, Outcome::endTime);
        QCOMPARE(bytesHeld, before);
    }

    void wavesAreNotKeptOfABlowThatIsNotSolved() {
        NetworkSettings settings = settingsOf(NetworkAccuracy::quick);
        NetworkSolver solver;
        solver.solve(t38(), settings);
        const std::size_t before = bytesHeld;
        settings.wants.histories = true;
        std::stop_source stopped;
        stopped.request_stop();
        QVERIFY(!solver.solve(t38(), settings, stopped.get_token()).waves);
        QVERIFY2(bytesHeld < before + 1000, QByteArray::number(qulonglong(bytesHeld - before)));
    }

  private:
    static std::vector<Problem> problems() {
        return {t38(), withMasses(), withLosses(), withFewSections(), withOddLengths()};
    }
    static void strings() {
        QTest::addColumn<int>("string");
        QTest::addColumn<int>("accuracy");
        int number = 0;
        for (const char* name : {"t38", "lumped masses", "losses", "few sections", "odd lengths"})
            QTest::newRow(name) << number++ << int(NetworkAccuracy::quick);
        QTest::newRow("t38, sure") << 0 << int(NetworkAccuracy::sure);
    }
};

QTEST_GUILESS_MAIN(TestNetworkWorkspace)
#include "tst_network_workspace.moc"
