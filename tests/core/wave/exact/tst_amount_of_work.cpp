// SPDX-License-Identifier: GPL-3.0-or-later
// How much work the exact solver does in the scenes of the benchmark, counted: a loss of speed shows on every
// machine, busy or not.
#include <QtTest>

#include "tests/support/basis_comparison.h"
#include "tests/support/basis_scenes.h"
#include "tests/support/bench_scenes.h"
#include "tests/support/scenes.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// For e alone, but for the events: those are the ones that a summary lists.
struct Work {
    std::string scene;
    long pieces, abandoned, events, searches, samples;
};

// At most so much each. Where the solver has become better, let the numbers fall: run the test with
// DRILLWAVE_PRINT_WORK=1 and put the lines that it prints in place of these.
const std::vector<Work> mostWork{
    {"elastic", 8, 0, 2, 2, 4},
    {"bilinear", 13, 0, 5, 10, 23},
    {"reference", 5, 0, 2, 2, 6},
    {"gap", 22, 0, 7, 17, 36},
    {"soft", 229, 0, 37, 45, 178},
    {"stiff", 8, 0, 3, 3, 10},
    {"near_elastic", 17, 0, 3, 4, 13},
    {"half_sine", 41, 0, 5, 7, 27},
    {"triangular", 41, 1, 5, 7, 29},
    {"piston", 193, 0, 5, 3, 20},
    {"softest", 5739, 0, 3, 2, 7},
    {"stiffest", 89, 0, 3, 26, 303},
    {"rectangular 0.5 0.1", 13, 0, 5, 10, 23},
    {"rectangular 0.5 1", 8, 0, 2, 2, 4},
    {"rectangular 5 0.1", 8, 0, 3, 4, 12},
    {"rectangular 5 1", 7, 0, 2, 2, 6},
    {"triangular 0.5 0.1", 41, 1, 5, 7, 29},
    {"triangular 0.5 1", 19, 1, 2, 2, 8},
    {"triangular 5 0.1", 70, 1, 3, 2, 11},
    {"triangular 5 1", 38, 1, 2, 2, 8},
    {"half_sine 0.5 0.1", 41, 0, 5, 7, 27},
    {"half_sine 0.5 1", 19, 0, 2, 2, 8},
    {"half_sine 5 0.1", 66, 0, 3, 2, 9},
    {"half_sine 5 1", 38, 0, 2, 2, 8},
    {"trapezoid 0.5 0.1", 44, 1, 5, 6, 25},
    {"trapezoid 0.5 1", 22, 1, 2, 2, 8},
    {"trapezoid 5 0.1", 62, 1, 3, 4, 14},
    {"trapezoid 5 1", 38, 1, 2, 2, 8},
    {"exponential 0.5 0.1", 200, 0, 5, 4, 29},
    {"exponential 0.5 1", 38, 0, 2, 3, 19},
    {"exponential 5 0.1", 1195, 0, 3, 8, 36},
    {"exponential 5 1", 203, 0, 2, 1, 13},
    {"piston 0.5 0.1", 193, 0, 5, 3, 20},
    {"piston 0.5 1", 66, 0, 2, 1, 6},
    {"piston 5 0.1", 858, 0, 3, 6, 19},
    {"piston 5 1", 195, 0, 2, 1, 10},
    {"table 0.5 0.1", 219, 0, 7, 6, 26},
    {"table 0.5 1", 160, 0, 2, 2, 8},
    {"table 5 0.1", 136, 0, 3, 2, 10},
    {"table 5 1", 138, 0, 2, 1, 5},
    {"rigid_body 0.5 0.1", 7, 0, 3, 4, 20},
    {"rigid_body 0.5 1", 5, 0, 2, 2, 6},
    {"rigid_body 5 0.1", 6, 0, 3, 3, 7},
    {"rigid_body 5 1", 5, 0, 2, 2, 6},
};

Work workOf(const NamedScene& named) {
    const Impact impact = solve(named.scene), summary = solve(named.scene, Detail::summary);
    return {named.name,      impact.pieces, impact.abandoned, long(summary.events.size()),
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
            const BasisResult& used = found.closed.isSolved() ? found.closed : found.series;
            QCOMPARE(impact.pieces, used.impact.pieces);
            QCOMPARE(impact.searches, used.impact.searches);
            QCOMPARE(impact.samples, used.impact.samples);
            QVERIFY(impact.samples >= impact.searches);
            QCOMPARE(impact.abandoned, found.closed.isSolved() ? 0 : found.closed.impact.pieces);
            abandoned += impact.abandoned > 0;
        }
        QVERIFY2(abandoned > 0, "no scene tries this");
    }
};

QTEST_GUILESS_MAIN(TestAmountOfWork)
#include "tst_amount_of_work.moc"
