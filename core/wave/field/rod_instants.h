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

/// Side of a breakpoint of a wave from which its value is taken: the start of a piece, its inside, or its
/// end.
enum class Side { start, inside, end };

/// Values of both waves at the front end of the rod at one time.
struct Instant {
    /// Recorded time at the front end, in units of t0.
    double time;
    /// Side of the time from which the values are taken, if a piece of the wave ends there.
    Side side;
    /// Incident wave g, in units of F0, compression positive.
    double incident;
    /// Reflected wave r = F − g, in units of F0, compression positive.
    double reflected;
};

/// Bounds of the deviation of a wave from its chords, in units of F0, both ≥ 0, for a piece of length l. Over
/// a chord of length d, the wave is at most above·(d/l)² above the chord and at most below·(d/l)² below it.
struct WaveBends {
    double above = 0, below = 0;
};

/// Deviations of both waves from their chords in one piece of the histories, and the number of chords that
/// the piece needs.
struct PieceBends {
    /// Bounds of the deviation of the incident and of the reflected wave from their chords, in units of F0.
    WaveBends incident, reflected;
    /// Rounding error of the values and deviations of both waves, in units of F0; 0 if both are constant.
    double rounding = 0;
    /// Number of parts of equal length whose chords miss neither wave by more than 1e-4 of the peak force; 1
    /// … 64.
    int parts = 1;
};
/// Returns the bounds and the number of parts for piece number `index` of the recorded histories.
PieceBends bendsOfPiece(const Impact& impact, std::size_t index);

/// Returns both waves in piece number `index` of the histories, at the time x after its start, in units of
/// t0.
Instant instantIn(const Impact& impact, std::size_t index, double x, Side side);

/// Returns the end of part number `part` (1 … `parts`) of piece number `index`, as a time since the start of
/// the piece, in units of t0. For part 0 it returns the start of the piece, 0.
inline double endOfPart(const Impact& impact, std::size_t index, int part, int parts) {
    const double length = impact.incident.pieces()[index].length;
    return part == parts ? length : length * part / parts;
}
/// Returns the side of the end of part number `part`: the start of the piece for 0, its end for `parts`,
/// otherwise its inside.
inline Side sideOfPart(int part, int parts) {
    return part == 0 ? Side::start : part == parts ? Side::end : Side::inside;
}

/// Returns the number of the first piece of the histories that ends at the recorded time `from` or later.
std::size_t firstPieceUntil(const Impact& impact, double from);

/// Calls pass(piece, x, side) in order of time, x being the time since the start of the piece. The points are
/// both ends of every piece between the recorded times `from` and `until`, and the ends of the parts of a
/// curved piece. The times of `also`, which must increase, are added if they are inside these pieces.
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

/// Calls pass(instant) with the values of both waves in order of time, from the recorded time `from` to the
/// end of the recording. The instants are the ends of all pieces, points between them where a wave is curved,
/// and the times of `also`, which must increase.
template <class Pass>
void forEachInstant(const Impact& impact, double from, const std::vector<double>& also, Pass pass) {
    forEachPoint(impact, from, impact.incident.end(), also,
                 [&](std::size_t piece, double x, Side side) { pass(instantIn(impact, piece, x, side)); });
}

/// Returns the recorded time at the front end at which the blow is over, in units of t0: one transit after
/// the last separation.
double recordedEndOfBlow(const Impact& impact);

/// Returns the times b = 2·end − a, increasing, for the times a of all instants of the histories within half
/// a round trip of `end`. A wave that reaches the front end at a and one that left it at b meet in the rod at
/// the recorded time `end`. Only times b from `first` to `last` are included.
std::vector<double> counterparts(const Impact& impact, double end, double first, double last);
/// Returns the times b = 2·end − a for the times a of all instants of the histories within half a round trip
/// of `end`. A wave that reaches the front end at a and one that left it at b meet in the rod at the recorded
/// time `end`.
std::vector<double> counterparts(const Impact& impact, double end);

/// Returns incident and reflected wave at the front end before the first front arrives, at a time ≤ 0. They
/// are 0, or those of a uniform motion in the reference case (a rod that arrives as a rigid body).
Instant instantBeforeFront(const Impact& impact, double time);

/// Returns the values of both waves in the last round trip of the recording; after it the waves repeat for
/// ever.
std::vector<Instant> lastPeriod(const Impact& impact);

/// Returns the rounding error of the interval between `time` and one round trip earlier, in units of t0.
double roundingOfTrip(double time, double roundTrip);

// Upper bounds of both waves over stretches of time, used to skip stretches in which the largest force cannot
// lie.

// For the files of this folder only; they need an impact solved with Detail::histories.

/// Position at which a WaveSpan (several parts of a piece of the waves) is split in two.
enum class Cut {
    middle,
    /// Split after the first part of the span.
    front,
    /// Split before the last part of the span.
    back,
};

/// Part of the recording in which both waves at the front end follow the same two polynomials, between two
/// instants. It consists of one or more of the parts into which a piece of the histories is divided.
struct WaveSpan {
    std::size_t piece = 0;
    /// Range within the piece, which is divided into bends.parts parts: from the end of part number `first`
    /// to the end of part number `last`.
    int first = 0, last = 1;
    /// Deviation of the waves from their chords in the whole piece of the histories, and number of parts of
    /// the piece.
    PieceBends bends;
    /// Values of both waves at the start and the end of the span.
    Instant begin, end;
    /// Position at which the span is to be split in two.
    Cut cut = Cut::middle;

    /// Returns whether the span is a single part, which cannot be split.
    bool isOnePart() const { return last - first == 1; }
};

/// Returns whether `next` begins where `span` ends, in the same piece of the histories.
inline bool follows(const WaveSpan& span, const WaveSpan& next) {
    return span.piece == next.piece && span.last == next.first;
}

/// Upper bounds of the incident and of the reflected wave within a span, in units of F0. Both waves are
/// multiplied by a sign of 1 or −1 first.
struct SpanBound {
    double incident = 0, reflected = 0;
};
/// Returns upper bounds of the two waves multiplied by `sign` (1 or −1) within the span.
SpanBound boundOf(const WaveSpan& span, double sign);

/// Returns where to split a span for its incident wave multiplied by `sign` (1 or −1). If the wave is steep
/// and largest at an end of the piece, only the outermost part is split off, because the others can probably
/// be skipped. Otherwise the span is halved.
Cut cutForIncident(const WaveSpan& span, double sign);
/// Returns where to split a span for its reflected wave multiplied by `sign` (1 or −1). If that wave is steep
/// and largest at an end of the piece, only the outermost part is split off; otherwise the span is halved.
Cut cutForReflected(const WaveSpan& span, double sign);

/// Returns one span for each whole piece that ends at the recorded time `from` or later and begins at `until`
/// or before.
std::vector<WaveSpan> wholePieces(const Impact& impact, double from, double until);

/// Writes the spans, split more finely, into `parts`, which is cleared first. Every span of more than one
/// part becomes two spans, split at its member `cut`.
void cut(const Impact& impact, const std::vector<WaveSpan>& spans, std::vector<WaveSpan>& parts);

/// Writes the instants at the ends of the spans into `instants`, which is cleared first. Each instant appears
/// once, in order of time.
void endsOf(const std::vector<WaveSpan>& spans, std::vector<Instant>& instants);

/// Maximum of a sequence of numbers over any range of indices. A query takes a time proportional to the
/// logarithm of the length of the sequence.
class RangeMaximum {
  public:
    /// Replaces the sequence of numbers that over() searches.
    void assign(const std::vector<double>& numbers);
    /// Returns the largest of the numbers with index `first` ≤ i < `behind`; minus infinity if there are
    /// none.
    double over(std::size_t first, std::size_t behind) const;

  private:
    std::size_t m_count = 0;
    std::vector<double> m_tree;  ///< binary tree: m_count inner nodes, then the numbers
};

}  // namespace drillwave
