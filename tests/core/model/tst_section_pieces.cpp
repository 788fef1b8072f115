// SPDX-License-Identifier: GPL-3.0-or-later
// Uniform pieces that stand for sections of every kind.
#include <QTest>

#include <numbers>

#include "core/model/scales.h"
#include "core/model/section_pieces.h"

using namespace drillwave;

namespace {

Section cone() {
    Section section;
    section.length = 0.3;
    section.diameter = 0.04;
    section.bore = 0.01;
    section.endDiameter = 0.07;
    section.massAfter = 0.5;
    section.loss = 0.02;
    section.attenuation = 0.01;
    return section;
}

double massOf(const std::vector<Section>& pieces) {
    double mass = 0;
    for (const Section& piece : pieces) mass += propertiesOf(piece, {}).mass;
    return mass;
}

}  // namespace

class TestSectionPieces : public QObject {
    Q_OBJECT

  private slots:
    void aUniformSectionIsOnePiece() {
        Section section = cone();
        section.endDiameter.reset();
        QVERIFY(isUniform(section));
        QCOMPARE(uniformPieces(section, 1), std::vector<Section>{section});
        section.endDiameter = section.diameter;
        QVERIFY(isUniform(section));
        section.area = 1e-3;
        section.endArea = 2e-3;
        QVERIFY(!isUniform(section));
    }

    void theDiameterIsLinear() {
        using std::numbers::pi;
        QCOMPARE(areaAt(cone(), 0), pi / 4 * (0.04 * 0.04 - 0.01 * 0.01));
        QCOMPARE(areaAt(cone(), 1), pi / 4 * (0.07 * 0.07 - 0.01 * 0.01));
        QCOMPARE(outerDiameterAt(cone(), 0.5), 0.055);
        Section byArea;
        byArea.area = pi / 4 * 0.04 * 0.04;
        byArea.endArea = pi / 4 * 0.08 * 0.08;
        QCOMPARE(areaAt(byArea, 0.5), pi / 4 * 0.06 * 0.06);
        QCOMPARE(largestDiameter(byArea), 0.08);
    }

    void piecesHaveTheMassOfWhatTheyStandFor() {
        const double bar = std::numbers::pi / 12 * 0.3 * (0.04 * 0.04 + 0.04 * 0.07 + 0.07 * 0.07);
        const double mass = 7850 * (bar - std::numbers::pi / 4 * 0.01 * 0.01 * 0.3);
        QVERIFY(std::abs(propertiesOf(cone(), {}).mass / mass - 1) < 1e-14);
        for (const int count : {1, 2, 7, 128})
            for (const bool behindLoss : {false, true})
                QVERIFY(std::abs(massOf(uniformPieces(cone(), count, behindLoss)) / mass - 1) < 1e-13);
    }

    void firstPieceBehindALossHasTheAreaOfTheEnd() {
        Section toPoint = cone();
        toPoint.bore = 0;
        toPoint.endDiameter = 1e-6;
        for (const Section& section : {cone(), toPoint}) {
            const std::vector<Section> pieces = uniformPieces(section, 4, true);
            QCOMPARE(*pieces[0].area, areaAt(section, 0));
            QCOMPARE(*pieces[2].area, meanArea(section, 0.5, 0.75));
            QVERIFY(*pieces[1].area > 0);
        }
        QCOMPARE(*uniformPieces(cone(), 3, true)[0].area, meanArea(cone(), 0, 1.0 / 3));
    }

    void whatIsBehindASectionIsBehindItsLastPiece() {
        const std::vector<Section> pieces = uniformPieces(cone(), 3);
        QCOMPARE(pieces.size(), std::size_t{3});
        for (std::size_t i = 0; i < 3; ++i) {
            QVERIFY(isUniform(pieces[i]));
            QCOMPARE(pieces[i].length, 0.3 / 3);
            QCOMPARE(pieces[i].attenuation, 0.01);
            QCOMPARE(pieces[i].massAfter, i == 2 ? 0.5 : 0);
            QCOMPARE(pieces[i].loss, i == 2 ? 0.02 : 0);
        }
    }
};

QTEST_GUILESS_MAIN(TestSectionPieces)
#include "tst_section_pieces.moc"
