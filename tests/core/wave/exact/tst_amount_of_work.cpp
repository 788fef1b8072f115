// SPDX-License-Identifier: GPL-3.0-or-later
// How much work the exact solver does in the scenes of the benchmark, counted: a loss of speed shows on every
// machine, busy or not.
#include <QTest>

#include "tests/support/basis_comparison.h"
#include "tests/support/basis_scenes.h"
#include "tests/support/bench_scenes.h"
#include "tests/support/scenes.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// Work for only e, except for the events: those are the ones that a summary lists.
struct Work {
    std::string scene;
    long pieces, abandoned, events, searches, samples;
};

// At most so much each. After an improvement of the solver lower the numbers: run the test with
// DRILLWAVE_PRINT_WORK=1 and put the lines that it prints here instead.
const std::vector<Work> mostWork{
    {"elastic", 5, 0, 2, 0, 0},
    {"bilinear", 8, 0, 5, 1, 4},
    {"reference", 3, 0, 2, 1, 5},
    {"gap", 15, 0, 7, 8, 18},
    {"soft", 199, 0, 37, 42, 148},
    {"stiff", 5, 0, 3, 1, 8},
    {"near_elastic", 17, 0, 3, 4, 12},
    {"half_sine", 14, 0, 5, 14, 34},
    {"triangular", 17, 0, 5, 8, 21},
    {"piston", 50, 0, 5, 2, 8},
    {"softest", 5736, 0, 3, 2, 5},
    {"stiffest", 7, 0, 3, 1, 7},
    {"rectangular 0.5 0.1", 8, 0, 5, 1, 4},
    {"rectangular 0.5 1", 5, 0, 2, 0, 0},
    {"rectangular 5 0.1", 5, 0, 3, 2, 10},
    {"rectangular 5 1", 4, 0, 2, 1, 5},
    {"triangular 0.5 0.1", 17, 0, 5, 8, 21},
    {"triangular 0.5 1", 7, 0, 2, 1, 1},
    {"triangular 5 0.1", 11, 0, 3, 6, 16},
    {"triangular 5 1", 6, 0, 2, 4, 10},
    {"half_sine 0.5 0.1", 14, 0, 5, 14, 34},
    {"half_sine 0.5 1", 8, 0, 2, 3, 9},
    {"half_sine 5 0.1", 9, 0, 3, 9, 26},
    {"half_sine 5 1", 7, 0, 2, 3, 9},
    {"trapezoid 0.5 0.1", 12, 0, 5, 7, 15},
    {"trapezoid 0.5 1", 9, 0, 2, 1, 1},
    {"trapezoid 5 0.1", 8, 0, 3, 4, 11},
    {"trapezoid 5 1", 7, 0, 2, 2, 5},
    {"exponential 0.5 0.1", 12, 0, 5, 8, 31},
    {"exponential 0.5 1", 8, 0, 2, 5, 18},
    {"exponential 5 0.1", 8, 0, 3, 5, 21},
    {"exponential 5 1", 5, 0, 2, 3, 10},
    {"piston 0.5 0.1", 50, 0, 5, 2, 8},
    {"piston 0.5 1", 43, 0, 2, 1, 4},
    {"piston 5 0.1", 43, 0, 3, 2, 10},
    {"piston 5 1", 42, 0, 2, 1, 5},
    {"table 0.5 0.1", 219, 0, 7, 6, 21},
    {"table 0.5 1", 160, 0, 2, 2, 7},
    {"table 5 0.1", 62, 0, 3, 16, 20},
    {"table 5 1", 65, 0, 2, 4, 5},
    {"rigid_body 0.5 0.1", 4, 0, 3, 1, 5},
    {"rigid_body 0.5 1", 3, 0, 2, 1, 5},
    {"rigid_body 5 0.1", 4, 0, 3, 2, 6},
    {"rigid_body 5 1", 3, 0, 2, 1, 5},
};

Work workOf(const NamedScene& named) {
    const Impact impact = solve(named.scene), listed = solve(named.scene, Detail::events);
    return {named.name,      impact.pieces, impact.abandoned, long(listed.events.size()),
            impact.searches, impact.samples};
}

QString row(const Work& work) {
    return QStringLiteral("    {\"%1\", %2, %3, %4, %5, %6},")
        .arg(QString::fromStdString(work.scene))
        .arg(work.pieces)
        .arg(work.abandoned)
        .arg(work.events)
        .arg(work.searches)
        .arg(work.samples);
}

}  // namespace

class TestAmountOfWork : public QObject {
    Q_OBJECT

  private slots:
    void noSceneNeedsMoreThanItDid_data() {
        QTest::addColumn<int>("index");
        const auto scenes = benchScenes();
        for (std::size_t i = 0; i < scenes.size(); ++i) QTest::newRow(scenes[i].name.c_str()) << int(i);
    }
    void noSceneNeedsMoreThanItDid() {
        QFETCH(const int, index);
        const NamedScene named = benchScenes()[std::size_t(index)];
        const Work now = workOf(named);
        if (qEnvironmentVariableIsSet("DRILLWAVE_PRINT_WORK")) std::printf("%s\n", qPrintable(row(now)));
        const auto most = std::ranges::find(mostWork, named.name, &Work::scene);
        QVERIFY2(most != mostWork.end(), qPrintable(row(now)));
        const bool isMore = now.pieces > most->pieces || now.abandoned > most->abandoned ||
                            now.events > most->events || now.searches > most->searches ||
                            now.samples > most->samples;
        QVERIFY2(!isMore,
                 qPrintable(QStringLiteral("now\n") + row(now) + QStringLiteral("\nnot\n") + row(*most)));
    }

    void whatTheClosedMarchLeavesToSeriesIsCounted() {
        BasisScenes scenes(5);
        BasisComparison comparison;
        int abandoned = 0;
        for (unsigned i = 0; i < 800; ++i) {
            const BasisFinding found = comparison.compare(scenes.scene(i), false, false);
            if (!found.series.isSolved() || found.growth() > coveredGrowth) continue;
            const Impact impact = solve(found.scene);
            const bool isClosed = found.closed.isSolved() && impact.abandoned == 0;
            const BasisResult& used = isClosed ? found.closed : found.series;
            // what has been solved is given up only where digits were lost
            QVERIFY(isClosed || !found.closed.isSolved() || found.closed.impact.corError > 1e-13);
            QCOMPARE(impact.pieces, used.impact.pieces);
            QCOMPARE(impact.searches, used.impact.searches);
            QCOMPARE(impact.samples, used.impact.samples);
            QVERIFY(impact.samples >= impact.searches);
            // a closed march ends as soon as its error is too large
            const long closedPieces = isClosed ? 0 : found.closed.impact.pieces;
            QVERIFY(impact.abandoned <= closedPieces && (impact.abandoned > 0) == (closedPieces > 0));
            abandoned += impact.abandoned > 0;
        }
        QVERIFY2(abandoned > 0, "no scene tries this");
    }

    void aMarchWhoseErrorIsTooLargeIsNotGoneOnWith() {
        // in closed form its terms are a thousand times as large as the force
        const Problem problem = problemOf(pulseForceOf(PulseShape::rectangular), {0.06, 0.7, 10, 0});
        const Impact impact = ExactSolver().solve(problem);
        QCOMPARE(impact.outcome, Outcome::rebounded);
        QVERIFY2(impact.abandoned > 0 && impact.abandoned < 15,
                 qPrintable(QString::number(impact.abandoned)));
    }

    void softRockStaysClosed_data() {
        QTest::addColumn<double>("beta");
        QTest::addColumn<double>("gamma");
        for (const double beta : {0.06, 0.08, 0.1, 0.14, 0.2})
            for (const double gamma : {0.1, 0.5, 1.0})
                QTest::addRow("beta %g, gamma %g", beta, gamma) << beta << gamma;
    }
    void softRockStaysClosed() {
        QFETCH(const double, beta);
        QFETCH(const double, gamma);
        const Impact impact =
            ExactSolver().solve(problemOf(pulseForceOf(PulseShape::rectangular), {beta, gamma, 10, 0}));
        QCOMPARE(impact.outcome, Outcome::rebounded);
        QCOMPARE(impact.abandoned, 0L);
    }
};

QTEST_GUILESS_MAIN(TestAmountOfWork)
#include "tst_amount_of_work.moc"
