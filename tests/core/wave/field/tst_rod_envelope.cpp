// SPDX-License-Identifier: GPL-3.0-or-later
// The largest forces along the rod, against every section and time looked at, and against the largest of all.
#include <QTest>

#include "core/wave/field/bit_history.h"
#include "core/wave/field/history_reader.h"
#include "core/wave/field/rod_envelope.h"
#include "core/wave/field/wave_field.h"
#include "tests/support/scenes.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

constexpr std::size_t fewPieces = 120;

struct Solved {
    Impact impact;
    RodEnvelope envelope;
};

Solved solved(const Scene& scene) {
    Solved blow{solve(scene, Detail::histories), {}};
    blow.envelope = rodEnvelope(blow.impact, problemOf(scene).force());
    return blow;
}

/// One of the four lines, its sign and its largest.
struct Line {
    const char* name;
    const EnvelopeLine& points;
    const RodForce& largest;
    double sign;  ///< of compression
    bool after;
};

std::array<Line, 4> linesOf(const RodEnvelope& e) {
    return {Line{"compression", e.compression, e.largest.compression, 1, false},
            Line{"tension", e.tension, e.largest.tension, -1, false},
            Line{"compression after", e.compressionAfter, e.largest.compressionAfter, 1, true},
            Line{"tension after", e.tensionAfter, e.largest.tensionAfter, -1, true}};
}

/// Returns the sum of the two waves at a section and time, on whichever sides of jumps it is largest.
double largestBeside(const Impact& impact, double sign, const RodForce& at) {
    const double tau = impact.roundTrip / 2;
    const double incoming = at.time - impact.frontArrival + (1 - at.section) * tau;
    const double leaving = at.time - impact.frontArrival - (1 - at.section) * tau;
    const double beside = 1e-11 * (std::abs(at.time) + impact.roundTrip);
    double most = -1e300;
    for (const double a : {incoming - beside, incoming, incoming + beside})
        for (const double b : {leaving - beside, leaving, leaving + beside}) {
            const bool areInRod = a - b >= -beside / 2 && a - b <= impact.roundTrip + beside / 2;
            if (!areInRod) continue;
            const double reflected = impactForce(impact, b) - incidentWave(impact, b);
            most = std::max(most, sign * (incidentWave(impact, a) + reflected));
        }
    return most;
}

/// Chords miss each of two waves by 1e-4 of the largest force, more where a piece has as many as it may have.
double tolerance(const Scene& scene, const Impact& impact) {
    return 1e-3 * std::max({impact.peakForce, problemOf(scene).force().peak, incidentWave(impact, 0)});
}

/// The largest of sign·(−N) at a section while the blow lasts, or in the round trips after it: at all
/// breakpoints of both waves, from both sides, and between.
double scanned(const Impact& impact, double xi, double sign, bool after) {
    const double blowEnd = impact.separationTime + impact.roundTrip / 2;
    const double tau = impact.roundTrip / 2, late = (1 - xi) * tau;
    const double from = after ? blowEnd : 0, to = after ? blowEnd + 2 * impact.roundTrip : blowEnd;
    std::vector<double> times;
    for (int i = 0; i <= 100; ++i) times.push_back(from + (to - from) * i / 100);
    for (const auto& piece : impact.incident.pieces())
        for (const double beside : {-1e-10, 1e-10})
            for (const double delay : {-late, late}) {
                const double t =
                    timeOfRecorded(impact, piece.start) + beside * tau + impact.frontArrival + delay;
                times.push_back(t);
            }
    double most = 0;
    const WaveField field(impact);
    for (const double t : times)
        if (t >= from && t <= to) most = std::max(most, -sign * field.force(xi, t));
    return most;
}

QByteArray at(const Scene& scene, const Line& line, double xi) {
    return QByteArray::fromStdString(describe(scene)) + ": " + line.name + " at " +
           QByteArray::number(xi, 'g', 17);
}

void staysAboveTheScan(const Scene& scene, const Solved& blow) {
    const double tau = blow.impact.roundTrip / 2;
    // Neither contains the later part of the hammer's force.
    const bool hammerEnds =
        problemOf(scene).force().end + blow.impact.frontArrival <= blow.impact.separationTime;
    for (const Line& line : linesOf(blow.envelope)) {
        if (line.after && !hammerEnds) continue;
        for (const double xi : {0.003, 0.1234, 0.25, 0.381, 0.5, 0.67, 0.75, 0.912, 0.999}) {
            // Fronts pass here in less than a rounding where the rod is long.
            if (xi * (1 - xi) * tau < 1e-6) continue;
            const double found = forceAt(line.points, xi).size;
            const double seen = scanned(blow.impact, xi, line.sign, line.after);
            QVERIFY2(seen <= found + tolerance(scene, blow.impact), at(scene, line, xi) + ": " +
                                                                        QByteArray::number(seen) + " above " +
                                                                        QByteArray::number(found));
        }
    }
}

void isThereWhereItSays(const Scene& scene, const Solved& blow) {
    const double blowEnd = blow.impact.separationTime + blow.impact.roundTrip / 2;
    for (const Line& line : linesOf(blow.envelope)) {
        const std::size_t step = std::max<std::size_t>(1, line.points.size() / 300);
        for (std::size_t i = 0; i < line.points.size(); i += step) {
            const RodForce& point = line.points[i];
            if (point.size == 0) continue;
            const double there = largestBeside(blow.impact, line.sign, point);
            // Where two jumps meet, what is beside the point may belong to the next line.
            double most = 0;
            for (const double beside : {-1e-9, 0.0, 1e-9})
                most = std::max(most, forceAt(line.points, point.section + beside).size);
            const double tolerated = tolerance(scene, blow.impact);
            QVERIFY2(there >= point.size - tolerated && there <= most + tolerated,
                     at(scene, line, point.section) + ": " + QByteArray::number(there) + " for " +
                         QByteArray::number(point.size));
            const double rounding = 1e-9 * (blowEnd + blow.impact.roundTrip);
            QVERIFY(line.after ? point.time >= blowEnd - rounding : point.time <= blowEnd + rounding);
        }
    }
}

void hasTheLargest(const Scene& scene, const Solved& blow) {
    const RodForces expected = largestRodForces(blow.impact, problemOf(scene).force());
    QCOMPARE(blow.envelope.largest, expected);
    for (const Line& line : linesOf(blow.envelope)) {
        QVERIFY(!line.points.empty());
        QCOMPARE(line.points.front().section, 0.0);
        QCOMPARE(line.points.back().section, 1.0);
        QVERIFY(std::ranges::is_sorted(line.points, {}, &RodForce::section));
        const auto most = std::ranges::max_element(line.points, {}, &RodForce::size);
        QVERIFY2(most->size == line.largest.size, at(scene, line, most->section));
        QVERIFY(forceAt(line.points, line.largest.section).size <= line.largest.size);
    }
}

}  // namespace

class TestRodEnvelope : public QObject {
    Q_OBJECT

  private slots:
    void aPulsePassesEverySection() {
        // A half sine that is short against the rod: its peak on the way down everywhere, twice that at the
        // bit of stiff elastic rock, and tension where it comes back from the free end.
        const Solved blow = solved({PulseShape::halfSine, {1e6, 1, 10, 0}});
        const double peak = std::acos(-1.0) / 2;
        for (const double xi : {0.1, 0.5, 0.9}) {
            const RodForce force = forceAt(blow.envelope.compression, xi);
            QVERIFY(std::abs(force.size - peak) < 1e-4);
            QVERIFY(std::abs(forceAt(blow.envelope.tension, xi).size - peak) < 1e-4);
        }
        QVERIFY(std::abs(forceAt(blow.envelope.compression, 1).size - 2 * peak) < 1e-3);
        // Half of the way back the pulse has left itself behind.
        QVERIFY(std::abs(forceAt(blow.envelope.compression, 0.949).size - peak) < 1e-3);
    }

    void theStruckEndHasTheHammer() {
        const Solved blow = solved({PulseShape::triangular, {0.5, 0.3, 3, 0}});
        QCOMPARE(blow.envelope.compression.front().section, 0.0);
        QVERIFY(std::abs(blow.envelope.compression.front().size - 2) < 1e-12);
        QVERIFY(std::abs(blow.envelope.compression.front().time - 0.5) < 1e-12);
        QVERIFY(forceAt(blow.envelope.tension, 0).size < 1e-3);
    }

    void thinWavesAreFound() {
        // (rod forces: waves of +1 and −2 as thin as 1e-6, which meet 1/20 from the ends)
        const Solved blow = solved({PulseShape::rectangular, {1e6, 1, 10, 0}});
        const RodForce& most = blow.envelope.largest.compressionAfter;
        QVERIFY(std::abs(forceAt(blow.envelope.compressionAfter, most.section).size - 3) < 1e-9);
        QVERIFY(forceAt(blow.envelope.compressionAfter, most.section + 1e-4).size < 2.5);
        QVERIFY(forceAt(blow.envelope.compressionAfter, most.section - 1e-4).size < 2.5);
    }

    void everySectionAndTimeStaysBelow_data() { addRodScenes(); }

    void everySectionAndTimeStaysBelow() {
        QFETCH(Scene, scene);
        const Solved blow = solved(scene);
        QCOMPARE(blow.envelope.missed, 0.0);
        hasTheLargest(scene, blow);
        staysAboveTheScan(scene, blow);
        isThereWhereItSays(scene, blow);
    }

    void manyPiecesStayBelow() {
        for (const Scene& scene : {Scene{PulseShape::piston, {0.2, 0.04, 8.4, 1}},
                                   Scene{PulseShape::trapezoid, {0.026, 0.16, 0.5, 2}},
                                   Scene{PulseShape::halfSine, {0.06, 0.125, 22, 1}}}) {
            const Solved blow = solved(scene);
            QVERIFY(blow.impact.incident.pieces().size() > fewPieces);
            QCOMPARE(blow.envelope.missed, 0.0);
            hasTheLargest(scene, blow);
            staysAboveTheScan(scene, blow);
            isThereWhereItSays(scene, blow);
        }
    }

    void randomRodsStayBelow() {
        int looked = 0;
        RandomScenes(engineeringDomain, 71)
            .forEachSolved(400, Detail::histories, [&](const Scene& scene, const Impact& impact) {
                // Hundreds of pieces take long to be looked at everywhere.
                if (impact.incident.pieces().size() > fewPieces) return;
                const Solved blow{impact, rodEnvelope(impact, problemOf(scene).force())};
                QVERIFY(blow.envelope.steps <= 4'000'000);
                QCOMPARE(blow.envelope.missed, 0.0);
                hasTheLargest(scene, blow);
                staysAboveTheScan(scene, blow);
                isThereWhereItSays(scene, blow);
                ++looked;
            });
        QVERIFY2(looked >= 240, QByteArray::number(looked) + " rods have been looked at");
    }

    void workHasAnEnd() {
        // Without enough of it the lines are too low by no more than is said.
        const Scene scene{PulseShape::halfSine, {2, 0.05, 3.3, 0.9}};
        const Impact impact = solve(scene, Detail::histories);
        const PulseForce hammer = problemOf(scene).force();
        const RodEnvelope whole = rodEnvelope(impact, hammer);
        const RodEnvelope few = rodEnvelope(impact, hammer, {}, 40);
        QVERIFY(few.steps <= 4 * 40);
        QVERIFY(few.missed > 0);
        for (const double xi : {0.05, 0.3, 0.6, 0.95}) {
            const double missing = forceAt(whole.tension, xi).size - forceAt(few.tension, xi).size;
            QVERIFY(missing >= -1e-9 && missing <= few.missed + 1e-9);
        }
        hasTheLargest(scene, {impact, few});
        std::stop_source stop;
        stop.request_stop();
        const RodEnvelope none = rodEnvelope(impact, hammer, stop.get_token());
        QCOMPARE(none.steps, 0);
        QVERIFY(none.missed > 0);
    }
};

QTEST_GUILESS_MAIN(TestRodEnvelope)
#include "tst_rod_envelope.moc"
