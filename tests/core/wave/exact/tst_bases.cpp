// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever representation of the waves solves a blow, e is the same within the bounds that they state.
#include <QTest>

#include "tests/support/basis_comparison.h"
#include "tests/support/basis_scenes.h"
#include "tests/support/tries.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// Some for every run of the tests. DRILLWAVE_BASES_SCENES=200000 takes minutes; compare_bases says more.
unsigned scenesToTry() {
    return unsigned(tries("DRILLWAVE_BASES_SCENES", 1000, 3000));
}

std::string words(const BasisFinding& found) {
    return describe(found.scene) + ": closed " + formatNumber(found.closed.impact.cor) + ", series " +
           formatNumber(found.series.impact.cor) + ", long double " + formatNumber(found.extended.impact.cor);
}

}  // namespace

class TestBases : public QObject {
    Q_OBJECT

  private slots:
    void closedFormSeriesAndLongDoubleAgreeWithinTheirBounds() {
        BasisScenes scenes(2);
        BasisComparison comparison;
        unsigned closed = 0, series = 0, truths = 0, wrongOfGrowth = 0;
        for (unsigned i = 0; i < scenesToTry(); ++i) {
            const BasisFinding found = comparison.compare(scenes.scene(i), i / 8 % 10 == 0, false);
            closed += found.closed.isSolved();
            series += found.series.isSolved();
            truths += found.extended.isSolved();
            QVERIFY2(found.growth() > coveredGrowth || !found.isWrong(), words(found).c_str());
            wrongOfGrowth += found.isWrong();
        }
        // those with tens of contacts hold in 99 of 100 (ExactSolver)
        QVERIFY2(wrongOfGrowth <= 2 + scenesToTry() / 1000, std::to_string(wrongOfGrowth).c_str());
        // checks that were not made say nothing
        QVERIFY2(closed > scenesToTry() / 10, std::to_string(closed).c_str());
        QVERIFY2(series > scenesToTry() * 9 / 10, std::to_string(series).c_str());
        QVERIFY2(truths > scenesToTry() / 20, std::to_string(truths).c_str());
    }

    void onSoftRockTheClosedFormHasTheDigitsThatItStates() {
        // closed marches of several round trips, by how soft the rock is and how much it remembers
        Chance chance(6);
        BasisComparison comparison;
        comparison.triesUnsuited = true;
        for (const double softest : {0.02, 0.1})
            for (const double leastGamma : {0.05, 0.3, 1.0}) {
                unsigned compared = 0;
                for (unsigned i = 0; i < scenesToTry() / 30; ++i) {
                    Scene scene;
                    scene.groups.beta = chance.logarithmic(softest, 5 * softest);
                    scene.groups.gamma = chance.logarithmic(leastGamma, std::min(1.0, 2 * leastGamma));
                    scene.groups.tau = chance.logarithmic(2, 20);
                    scene.groups.delta = chance.oneIn(2) ? 0 : 3 * chance.fraction();
                    const BasisFinding found = comparison.compare(scene, true, false);
                    if (!found.closed.isSolved() || found.growth() > coveredGrowth) continue;
                    ++compared;
                    QVERIFY2(found.closed.differenceTo(found.extended) <= found.closed.impact.corError,
                             words(found).c_str());
                }
                QVERIFY2(compared > scenesToTry() / 100, std::to_string(compared).c_str());
            }
    }

    void aRodThatFliesThroughManyReflectionsHasTheDigitsThatItStates() {
        // far from the rock, and very short: hundreds of pieces pass between the contacts
        Scene piston{PulseShape::piston,
                     {26.216271883836566, 0.2963206421811403, 0.0521557175795273, 1.8515142663604076}};
        piston.impedanceRatio = 1.8442978359751079;
        const std::vector<Scene> scenes{
            {PulseShape::exponential, {738.1488807791279, 1, 0.07251842414085019, 1.0000000000000386}},
            {PulseShape::exponential, {109.32463503258843, 1, 0.053945240121309336, 1.430522615380542}},
            piston};
        BasisComparison comparison;
        for (const Scene& scene : scenes) {
            const BasisFinding found = comparison.compare(scene, true, false);
            for (const BasisResult& result : {found.closed, found.series}) {
                QVERIFY2(result.isSolved() && found.extended.isSolved(), words(found).c_str());
                QVERIFY2(result.differenceTo(found.extended) <= result.impact.corError, words(found).c_str());
            }
        }
    }

    void energiesAndPeaksAgreeAsWell() {
        BasisScenes scenes(3);
        BasisComparison comparison;
        comparison.detail = Detail::ledger;
        unsigned compared = 0;
        for (unsigned i = 0; i < scenesToTry() / 4; ++i) {
            const BasisFinding found = comparison.compare(scenes.scene(i), false, false);
            if (!found.closed.isSolved() || !found.series.isSolved() || found.growth() > coveredGrowth)
                continue;
            ++compared;
            const Impact &a = found.closed.impact, &b = found.series.impact;
            // rounding summed over up to hundreds of pieces, of works up to 10
            const auto agree = [](double x, double y) { return std::abs(x - y) <= 1e-12 * std::max(1.0, y); };
            QVERIFY2(agree(a.peakForce, b.peakForce), words(found).c_str());
            QVERIFY2(agree(a.rockWork, b.rockWork), words(found).c_str());
            QVERIFY2(agree(a.hammerWork, b.hammerWork), words(found).c_str());
            QVERIFY2(agree(a.finalMomentum, b.finalMomentum), words(found).c_str());
            QVERIFY2(agree(a.finalEnergy, b.finalEnergy), words(found).c_str());
            QVERIFY2(agree(a.hammerWork, a.rockWork + a.finalEnergy), words(found).c_str());
        }
        QVERIFY2(compared > scenesToTry() / 40, std::to_string(compared).c_str());
    }

    void theLatticeAgreesWithinItsEstimate() {
        BasisScenes scenes(4);
        BasisComparison comparison;
        unsigned compared = 0;
        for (unsigned i = 0; i < scenesToTry() / 30; ++i) {
            const BasisFinding found = comparison.compare(scenes.scene(i), false, true);
            if (!found.lattice.isSolved()) continue;
            ++compared;
            QVERIFY2(found.closed.excessOver(found.lattice) <= 1, words(found).c_str());
        }
        QVERIFY2(compared > 0, std::to_string(compared).c_str());
    }
};

QTEST_GUILESS_MAIN(TestBases)
#include "tst_bases.moc"
