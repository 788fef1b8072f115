// SPDX-License-Identifier: GPL-3.0-or-later
// Both waves at the front end as straight lines between instants, in which the largest forces in the rod are
// searched.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/wave/impact.h"

namespace drillwave {

// For the files of this folder only; they need an impact solved with Detail::histories. Times are recorded
// times (history_reader.h) in t0, forces in F0.

/// Place of an instant in its polynomial piece: at the start of the piece, inside it, or at its end. Where a
/// wave jumps, it decides which of the two values is taken.
enum class Side { start, inside, end };

/// Values of the incident and the reflected wave at the front end of the rod at one time.
struct Instant {
    /// Time in the recorded histories at the front end, in units of t0. It leaves out the periods that were
    /// not recorded.
    double time;
    /// Place of `time` in its polynomial piece. Where the wave jumps, one piece ends and the next one begins
    /// at the same time; `side` then decides which value is taken.
    Side side;
    /// Incident wave g, in units of F0, compression positive.
    double incident;
    /// Reflected wave r = F − g, in units of F0, compression positive.
    double reflected;
};

/// Bounds of the deviation of a wave from straight chords within a polynomial piece of length l, in units of
/// F0; both ≥ 0. Over a chord of length d, the wave is at most above·(d/l)² above the chord, and at most
/// below·(d/l)² below it.
struct WaveBends {
    double above = 0, below = 0;
};

/// Curvature of one polynomial piece of the recorded waves at the front end. It says how far both waves
/// deviate from straight chords, and how many chords are needed.
struct PieceBends {
    /// Bounds, in units of F0, of the deviation of the incident and of the reflected wave from the chords
    /// that replace them.
    WaveBends incident, reflected;
    /// Bound of the rounding error in the values and deviations of both waves, in units of F0; 0 if both
    /// waves are constant.
    double rounding = 0;
    /// Number of equal parts into which the piece is divided, 1 … 64. In each part, the chord deviates from
    /// either wave by at most 1e-4 of the peak force, unless 64 parts are too few.
    int parts = 1;
};
/// Returns the curvature of piece number `index` of the histories: how far both waves deviate from straight
/// chords, and into how many parts the piece is divided.
PieceBends bendsOfPiece(const Impact& impact, std::size_t index);

/// Returns incident and reflected wave in piece number `index` of the histories, at the time x after the
/// start of the piece, in units of t0. `side` is copied into the result.
Instant instantIn(const Impact& impact, std::size_t index, double x, Side side);

/// Returns the time at which part number `part` of a piece of the histories ends, in units of t0 since the
/// start of the piece. The piece `index` is divided into `parts` equal parts, counted from 1. For part 0 it
/// returns 0, the start of the piece.
inline double endOfPart(const Impact& impact, std::size_t index, int part, int parts) {
    const double length = impact.incident.pieces()[index].length;
    return part == parts ? length : length * part / parts;
}
/// Returns where in its piece the end of part number `part` is: at the start of the piece for part 0, at its
/// end for the last part, and otherwise inside it.
inline Side sideOfPart(int part, int parts) {
    return part == 0 ? Side::start : part == parts ? Side::end : Side::inside;
}

/// Returns the index of the first piece of the recorded waves that is not over before the recorded time
/// `from`.
std::size_t firstPieceUntil(const Impact& impact, double from);

/// Calls pass(piece, x, side) for points of the recorded waves in order of time. `piece` is the index of a
/// polynomial piece, x the time since its start. The points are both ends of every piece between the recorded
/// times `from` and `until`. In curved pieces, the ends of their parts are added. The increasing times of
/// `also` are added if they are inside these pieces.
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

/// Calls pass(instant) with the values of incident and reflected wave in order of time, from the recorded
/// time `from` to the end of the recording. The instants are both ends of every polynomial piece, and points
/// inside a piece where a wave is curved. The increasing times of `also` are added.
template <class Pass>
void forEachInstant(const Impact& impact, double from, const std::vector<double>& also, Pass pass) {
    forEachPoint(impact, from, impact.incident.end(), also,
                 [&](std::size_t piece, double x, Side side) { pass(instantIn(impact, piece, x, side)); });
}

/// Returns the time in the recording at which the blow is over, in units of t0. It is one transit of the rod
/// after the last separation of bit and rock, when the wave of this separation reaches the rear end.
double recordedEndOfBlow(const Impact& impact);

/// Returns the time b = 2·end − a for every instant a of the histories within half a round trip of `end`, in
/// increasing order. The wave that reaches the front end at a and the wave that leaves it at b meet in the
/// rod exactly at the recorded time `end`. The search for the largest forces ends there and needs both times.
/// Only times b from `first` to `last` are included.
std::vector<double> counterparts(const Impact& impact, double end, double first, double last);
/// Returns the time b = 2·end − a for every instant a of the histories within half a round trip of `end`, in
/// increasing order. The wave that reaches the front end at a and the wave that leaves it at b meet in the
/// rod exactly at the recorded time `end`. The search for the largest forces ends there and needs both times.
std::vector<double> counterparts(const Impact& impact, double end);

/// Returns incident and reflected wave at the front end at a time ≤ 0, before the first wave arrives there.
/// They are 0, or those of a uniform motion in the reference case (a rod that arrives as a rigid body).
Instant instantBeforeFront(const Impact& impact, double time);

/// Returns the values of the incident and the reflected wave at the front end in the last round trip of the
/// recording. After the recording, the waves repeat for ever.
std::vector<Instant> lastPeriod(const Impact& impact);

/// Returns an upper bound of the rounding error of the difference of two times about one round trip apart, in
/// units of t0. `time` is the later of the two times.
double roundingOfTrip(double time, double roundTrip);

// Upper bounds of both waves over stretches of time, used to skip stretches in which the largest force cannot
// lie.

// For the files of this folder only; they need an impact solved with Detail::histories.

/// Position at which a span of the recording (WaveSpan) is split in two. A span covers one or more of the
/// equal parts of a polynomial piece.
enum class Cut {
    middle,
    /// Split after the first part of the span, which becomes a span of its own.
    front,
    /// Split before the last part of the span, which becomes a span of its own.
    back,
};

/// Part of the recorded waves at the front end between two instants. It lies in one polynomial piece, which
/// is divided into equal parts, and covers one or more of them.
struct WaveSpan {
    std::size_t piece = 0;
    /// Range of parts of the polynomial piece that the span covers: from the end of part `first` (0 is the
    /// start of the piece) to the end of part `last`. The piece consists of bends.parts equal parts.
    int first = 0, last = 1;
    /// Deviations of the waves from their chords in the polynomial piece of this span, and the number of
    /// parts of this piece.
    PieceBends bends;
    /// Values of both waves at the start and the end of the span.
    Instant begin, end;
    /// Position at which cut() splits the span in two.
    Cut cut = Cut::middle;

    /// Returns whether the span is a single part, which cannot be split.
    bool isOnePart() const { return last - first == 1; }
};

/// Returns whether `next` begins where `span` ends, in the same piece of the histories.
inline bool follows(const WaveSpan& span, const WaveSpan& next) {
    return span.piece == next.piece && span.last == next.first;
}

/// Upper bounds of the incident and the reflected wave within a span (part of the recording), in units of F0.
/// Both waves are first multiplied by 1 (for compression) or −1 (for tension).
struct SpanBound {
    double incident = 0, reflected = 0;
};
/// Returns upper bounds of incident and reflected wave within a span of the recording, both multiplied by
/// `sign` (1 for compression, −1 for tension). Spans whose bounds are too low need not be searched.
SpanBound boundOf(const WaveSpan& span, double sign);

/// Returns where to split a span (part of the recording) to find the largest value of its incident wave,
/// multiplied by `sign` (1 for compression, −1 for tension). If that wave is steep and largest at an end of
/// its piece, only the outermost part is split off, because the others can probably be skipped. Otherwise the
/// span is halved.
Cut cutForIncident(const WaveSpan& span, double sign);
/// Returns where to split a span (part of the recording) to find the largest value of its reflected wave,
/// multiplied by `sign` (1 for compression, −1 for tension). If that wave is steep and largest at an end of
/// its piece, only the outermost part is split off; otherwise the span is halved.
Cut cutForReflected(const WaveSpan& span, double sign);

/// Returns one span for each polynomial piece of the recorded waves that overlaps the recorded times from
/// `from` to `until`. Each span is a whole piece.
std::vector<WaveSpan> wholePieces(const Impact& impact, double from, double until);

/// Splits every span (part of the recording) of more than one part into two spans, at the position of its
/// member `cut`. Writes all spans into `parts`, which is cleared first.
void cut(const Impact& impact, const std::vector<WaveSpan>& spans, std::vector<WaveSpan>& parts);

/// Writes the instants at both ends of each span (part of the recording) into `instants`, in order of time.
/// `instants` is cleared first. The common end of two adjacent spans of a piece appears once.
void endsOf(const std::vector<WaveSpan>& spans, std::vector<Instant>& instants);

/// Maximum of a sequence of numbers over any range of indices. A query takes a time proportional to the
/// logarithm of the length of the sequence.
class RangeMaximum {
  public:
    /// Sets the sequence of numbers that over() searches.
    void assign(const std::vector<double>& numbers);
    /// Returns the largest of the numbers with an index from `first` to `behind` − 1; minus infinity if there
    /// are none.
    double over(std::size_t first, std::size_t behind) const;

  private:
    std::size_t m_count = 0;
    std::vector<double> m_tree;  ///< binary tree: m_count inner nodes, then the numbers
};

}  // namespace drillwave
