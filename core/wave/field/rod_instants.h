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
// (history_reader.h) in t0, forces in F0.

/// Side of a breakpoint on which a value is taken.
enum class Side { start, inside, end };

/// Both waves at one time of the front end.
struct Instant {
    double time;
    Side side;
    double incident;   ///< g
    double reflected;  ///< r = F − g
};

/// Bounds of the deviation of a wave from its chords within a piece of length l: over a chord of length d,
/// the wave is at most above·(d/l)² above the chord and at most below·(d/l)² below it.
struct WaveBends {
    double above = 0, below = 0;
};

/// The same of both waves, and into how many parts their piece is cut for that.
struct PieceBends {
    WaveBends incident, reflected;
    double rounding = 0;  ///< of their values and of their bends; none where both are constant
    int parts = 1;        ///< of equal length: chords miss the waves by no more than 1e-4 of the peak force
};
PieceBends bendsOfPiece(const Impact& impact, std::size_t index);

/// Returns both waves in piece `index` at the distance x from its start.
Instant instantIn(const Impact& impact, std::size_t index, double x, Side side);

/// Returns the end of part number `part` of `parts` of piece `index`; for part 0 the start of the piece.
inline double endOfPart(const Impact& impact, std::size_t index, int part, int parts) {
    const double length = impact.incident.pieces()[index].length;
    return part == parts ? length : length * part / parts;
}
inline Side sideOfPart(int part, int parts) {
    return part == 0 ? Side::start : part == parts ? Side::end : Side::inside;
}

/// The first piece that ends at `from` or later.
std::size_t firstPieceUntil(const Impact& impact, double from);

/// Calls pass(piece, x, side) in order of time for both ends of every piece that ends behind `from` and
/// begins until `until`, for points between where a wave is curved, and for the times of `also` within it,
/// which must rise.
template <class Pass>
void forEachPoint(const Impact& impact, double from, double until, const std::vector<double>& also,
                  Pass pass) {
    const auto pieces = impact.incident.pieces();
    for (std::size_t i = firstPieceUntil(impact, from); i < pieces.size() && pieces[i].start <= until; ++i) {
        const PiecewisePolynomial::Piece& piece = pieces[i];
        auto extra = std::ranges::upper_bound(also, piece.start);
        const int parts = bendsOfPiece(impact, i).parts;
        pass(i, 0.0, Side::start);
        for (int part = 1; part <= parts; ++part) {
            const double x = endOfPart(impact, i, part, parts);
            for (; extra != also.end() && *extra - piece.start < x; ++extra)
                pass(i, *extra - piece.start, Side::inside);
            pass(i, x, sideOfPart(part, parts));
        }
    }
}

/// Calls pass(instant) for the same points from `from` on.
template <class Pass>
void forEachInstant(const Impact& impact, double from, const std::vector<double>& also, Pass pass) {
    forEachPoint(impact, from, impact.incident.end(), also,
                 [&](std::size_t piece, double x, Side side) { pass(instantIn(impact, piece, x, side)); });
}

/// The recorded time of the front end at which the blow is over: one transit after the last separation.
double recordedEndOfBlow(const Impact& impact);

/// Returns counterparts: when waves meet at the recorded time `end`, one arrives as much later as the other
/// has left before. From `first` to `last`, of all instants within half a round trip of `end`.
std::vector<double> counterparts(const Impact& impact, double end, double first, double last);
/// Returns all counterparts.
std::vector<double> counterparts(const Impact& impact, double end);

/// Returns the state before the first front arrives, at a time ≤ 0: no waves, or a uniform motion.
Instant instantBeforeFront(const Impact& impact, double time);

/// Returns the last period of the recording, which repeats for ever: instants of one round trip.
std::vector<Instant> lastPeriod(const Impact& impact);

/// Returns the rounding error of the interval between `time` and one round trip earlier.
double roundingOfTrip(double time, double roundTrip);

// Stretches of both waves at the front end, and how large the waves are in them at most: where the largest
// forces need not be looked for.

// For the files of this folder only; of an impact solved with Detail::histories.

/// Place where a span is cut in two.
enum class Cut {
    middle,
    front,  ///< after its first part
    back,   ///< before its last part
};

/// Some neighbouring parts of a piece of both waves, between two instants.
struct WaveSpan {
    std::size_t piece = 0;
    int first = 0, last = 1;  ///< from the end of part number `first` to that of part `last`
    PieceBends bends;         ///< of the piece, and into how many parts that is cut
    Instant begin, end;
    Cut cut = Cut::middle;

    bool isOnePart() const { return last - first == 1; }
};

/// Returns whether `next` begins where `span` ends, in the same piece.
inline bool follows(const WaveSpan& span, const WaveSpan& next) {
    return span.piece == next.piece && span.last == next.first;
}

/// Upper bounds of the waves, times `sign`, in a span.
struct SpanBound {
    double incident = 0, reflected = 0;
};
SpanBound boundOf(const WaveSpan& span, double sign);

/// Returns where to cut a span that matters for its incident wave, times `sign`: where that is steep and
/// largest at an end of the piece, all but the part there may soon be left out.
Cut cutForIncident(const WaveSpan& span, double sign);
Cut cutForReflected(const WaveSpan& span, double sign);

/// Returns the pieces that end at `from` or later and begin until `until`, whole.
std::vector<WaveSpan> wholePieces(const Impact& impact, double from, double until);

/// Writes all spans into `parts`, cleared first; those of more than one part are split where `cut` says.
void cut(const Impact& impact, const std::vector<WaveSpan>& spans, std::vector<WaveSpan>& parts);

/// Writes the instants at their ends into `instants`, which is cleared first: each once, in order of time.
void endsOf(const std::vector<WaveSpan>& spans, std::vector<Instant>& instants);

/// Largest of neighbouring numbers, found in a time that grows with the logarithm of their count.
class RangeMaximum {
  public:
    void assign(const std::vector<double>& numbers);
    /// Returns the largest number from `first` to before `behind`; minus infinity if there are none.
    double over(std::size_t first, std::size_t behind) const;

  private:
    std::size_t m_count = 0;
    std::vector<double> m_tree;  ///< m_count inner nodes, then the numbers
};

}  // namespace drillwave
