// SPDX-License-Identifier: GPL-3.0-or-later
// Both waves at the front end as straight lines between instants: where the largest forces in the rod are
// looked for.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/wave/impact.h"

namespace drillwave {

// For the files of this folder only; of an impact solved with Detail::histories. Times are recorded times
// (recorded_time.h) in t0, forces in F0.

/// On which side of a breakpoint a value is taken.
enum class Side { start, inside, end };

/// Both waves at one time of the front end.
struct Instant {
    double time;
    Side side;
    double incident;   ///< g
    double reflected;  ///< r = F − g
};

/// Into how many parts piece `index` of both waves is cut, so that chords miss them by no more than 1e-4 of
/// the peak force.
int partsOfPiece(const Impact& impact, std::size_t index);

/// Calls pass(instant) in order of time for both ends of every piece that ends behind `from`, for points
/// between where a wave is curved, and for the times of `also` within it, which must rise.
template <class Pass>
void forEachInstant(const Impact& impact, double from, const std::vector<double>& also, Pass pass) {
    const auto incident = impact.incident.pieces();
    const auto force = impact.force.pieces();
    for (std::size_t i = 0; i < incident.size(); ++i) {
        const PiecewisePolynomial::Piece& piece = incident[i];
        if (piece.start + piece.length < from) continue;
        const auto at = [&](double x, Side side) {
            const double g = impact.incident.value(piece, x);
            const double F = force[i].count > 0 ? impact.force.value(force[i], x) : 0;
            pass(Instant{piece.start + x, side, g, F - g});
        };
        auto extra = std::ranges::upper_bound(also, piece.start);
        const auto passExtras = [&](double until) {
            for (; extra != also.end() && *extra - piece.start < until; ++extra)
                at(*extra - piece.start, Side::inside);
        };
        const int parts = partsOfPiece(impact, i);
        at(0, Side::start);
        for (int part = 1; part < parts; ++part) {
            const double x = piece.length * part / parts;
            passExtras(x);
            at(x, Side::inside);
        }
        passExtras(piece.length);
        at(piece.length, Side::end);
    }
}

/// The recorded time of the front end at which the blow is over: one transit after the last separation.
double recordedEndOfBlow(const Impact& impact);

/// When waves meet at the recorded time `end`, one comes in as much later as the other has left before:
/// the counterparts of all instants within half a round trip of `end`.
std::vector<double> counterparts(const Impact& impact, double end);

/// What the rod does before the first front arrives, at a time ≤ 0: nothing, or a uniform motion.
Instant instantBeforeFront(const Impact& impact, double time);

/// The last period of the recording, which repeats itself for ever: instants of one round trip.
std::vector<Instant> lastPeriod(const Impact& impact);

/// By how much two times one round trip apart may differ from it: `time` is the later of them.
double roundingOfTrip(double time, double roundTrip);

}  // namespace drillwave
