// SPDX-License-Identifier: GPL-3.0-or-later
// The largest forces along hammer and string: against a scan of the waves, the peaks of the sections and the
// envelope of the uniform rod.
#include <QTest>

#include "core/wave/field/rod_envelope.h"
#include "core/wave/network/network_solver.h"
#include "core/wave/network/string_waves.h"
#include "tests/support/network_scenes.h"
#include "tests/support/scenes.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// Where two fronts meet: what is at either side of the place.
std::vector<double> betweenFronts(const StringWaves& waves, std::size_t section, double xi, double t) {
    constexpr auto before = TimeSide::before, after = TimeSide::after;
    std::vector<double> forces;
    if (xi > 0) forces.push_back(waves.down(section, xi, t, after) + waves.up(section, xi, t, before));
    if (xi < 1) forces.push_back(waves.down(section, xi, t, before) + waves.up(section, xi, t, after));
    return forces;
}

/// The largest force of one sign in a section.
double peakOf(const SectionEnvelope& section, SectionPeak SectionForces::*sign) {
    double most = 0;
    for (const SectionForces& place : section) most = std::max(most, (place.*sign).force);
    return most;
}

}  // namespace

class TestStringEnvelope : public QObject {
    Q_OBJECT

  private slots:
    void scenes_data() {
        QTest::addColumn<QString>("id");
        for (const char* id : {"t38_medium", "t38_soft", "other_material", "mirror_hammer"})
            QTest::newRow(id) << QString(id);
    }

    void aScanOfTheWavesFindsNothingLarger_data() { scenes_data(); }
    void aScanOfTheWavesFindsNothingLarger() {
        QFETCH(QString, id);
        const Impact impact = solvedWithWaves(caseCalled(id.toStdString()).problem);
        QVERIFY(impact.waves);
        const StringWaves& waves = *impact.waves;
        for (std::size_t j = 0; j < waves.sections(); ++j)
            for (const double xi : {0.0, 0.31, 1.0}) {
                const SectionForces found = largestForcesAt(waves, j, xi, 2 * waves.end());
                double most = 0, least = 0;
                const std::vector<double> times = waves.pieceTimes(j, xi);
                for (std::size_t i = 0; i + 1 < times.size(); ++i)
                    for (int k = 0; k <= 8; ++k) {
                        const double t = std::lerp(times[i], times[i + 1], k / 8.0);
                        const double force =
                            waves.force(j, xi, t, k == 8 ? TimeSide::before : TimeSide::after);
                        most = std::max(most, force);
                        least = std::min(least, force);
                        if (k > 0) continue;
                        for (const double mixed : betweenFronts(waves, j, xi, t)) {
                            most = std::max(most, mixed);
                            least = std::min(least, mixed);
                        }
                    }
                const double size = std::max(most, -least);
                // a cubic over one piece rises above nine points of it by little; rounding otherwise
                QVERIFY(found.compression.force > most - 1e-9 * size - 1e-14);
                QVERIFY(found.compression.force < most + 1e-3 * size + 1e-14);
                QVERIFY(found.tension.force > -least - 1e-9 * size - 1e-14);
                QVERIFY(found.tension.force < -least + 1e-3 * size + 1e-14);
                for (const auto& [peak, sign] : {std::pair(found.compression, 1), {found.tension, -1}}) {
                    if (!(peak.force > 0)) continue;
                    double there = -size;
                    for (const TimeSide side : {TimeSide::before, TimeSide::after})
                        there = std::max(there, sign * waves.force(j, xi, peak.time, side));
                    for (const double mixed : betweenFronts(waves, j, xi, peak.time))
                        there = std::max(there, sign * mixed);
                    QVERIFY2(std::abs(there - peak.force) < 1e-9 * size,
                             QString("%1 at %2, not %3").arg(there).arg(peak.time).arg(peak.force).toUtf8());
                }
            }
    }

    void thePeaksAreThoseOfTheSections_data() { scenes_data(); }
    void thePeaksAreThoseOfTheSections() {
        QFETCH(QString, id);
        const Impact impact = solvedWithWaves(caseCalled(id.toStdString()).problem);
        const std::vector<SectionEnvelope> envelope = stringEnvelope(impact);
        QCOMPARE(envelope.size(), impact.sections.size());
        for (std::size_t j = 0; j < envelope.size(); ++j) {
            for (const auto sign : {&SectionForces::compression, &SectionForces::tension,
                                    &SectionForces::compressionAfter, &SectionForces::tensionAfter}) {
                const double known = (impact.sections[j].*sign).force, found = peakOf(envelope[j], sign);
                QVERIFY2(found == known,
                         QString("section %1: %2, not %3").arg(j).arg(found).arg(known).toUtf8());
                // the waves have it there but for the bend in a cell of the quicker run (strings §13)
                const SectionPeak peak = impact.sections[j].*sign;
                if (!(peak.force > 0)) continue;
                const double there =
                    (largestForcesAt(*impact.waves, j, peak.place, impact.endOfBlow, impact.forcesEnd).*sign)
                        .force;
                QVERIFY2(std::abs(there - known) < 1e-3 * known + 1e-9,
                         QString("section %1 at %2: %3, not %4")
                             .arg(j)
                             .arg(peak.place)
                             .arg(there)
                             .arg(known)
                             .toUtf8());
            }
            QCOMPARE(envelope[j].front().tension.place, 0.0);
            QCOMPARE(envelope[j].back().tension.place, 1.0);
            QVERIFY(std::ranges::is_sorted(envelope[j], {},
                                           [](const SectionForces& each) { return each.compression.place; }));
        }
    }

    void aStringOfOneRodHasTheEnvelopeOfTheRod() {
        const Groups groups{0.5, 0.1, 10, 0};
        const Scene uniform{PulseShape::rectangular, groups};
        const Impact exact = solve(uniform, Detail::histories);
        Problem problem = struck();
        problem.sections = {{.impedance = 1, .transitTime = 0.5},
                            {.impedance = 1, .transitTime = groups.tau}};
        hammerOf(problem).face.restrike = false;
        problem.law = {groups.beta, groups.gamma};
        problem.endTime = exact.separationTime + 4 * groups.tau;  // all of the waves left pass meanwhile
        const Impact impact = solvedWithWaves(problem);
        QVERIFY(impact.waves);
        const RodEnvelope rod = rodEnvelope(exact, problemOf(uniform).force());
        int compared = 0;
        for (double xi = 0.013; xi < 1; xi += 0.037) {
            const SectionForces found = largestForcesAt(*impact.waves, 1, xi, impact.endOfBlow);
            for (const auto& [force, line] : {std::pair(found.compression.force, &rod.compression),
                                              {found.tension.force, &rod.tension},
                                              {found.compressionAfter.force, &rod.compressionAfter},
                                              {found.tensionAfter.force, &rod.tensionAfter}}) {
                const double expected = forceAt(*line, xi).size;  // forces of 1 of the network are 2 F0
                QVERIFY2(std::abs(force - expected) < 1e-3,
                         QString("at %1: %2, not %3").arg(xi).arg(force).arg(expected).toUtf8());
                ++compared;
            }
        }
        QVERIFY(compared > 100);
    }

    void workIsBoundedAndEndsWhenItIsStopped() {
        const Impact impact = solvedWithWaves(caseCalled("t38_medium").problem);
        const auto places = [](const std::vector<SectionEnvelope>& envelope) {
            std::size_t sum = 0;
            for (const SectionEnvelope& section : envelope) sum += section.size();
            return sum;
        };
        const std::size_t fine = places(stringEnvelope(impact));
        const EnvelopeGrid coarse{.mostSteps = 1000};
        const std::size_t few = places(stringEnvelope(impact, {}, coarse));
        QVERIFY(fine > 400 && few <= impact.sections.size() * (coarse.leastOfSection + 5));
        std::stop_source stop;
        stop.request_stop();
        const std::vector<SectionEnvelope> none = stringEnvelope(impact, stop.get_token());
        QCOMPARE(none.size(), impact.sections.size());
        QCOMPARE(places(none), std::size_t{0});
    }
};

QTEST_GUILESS_MAIN(TestStringEnvelope)
#include "tst_string_envelope.moc"
