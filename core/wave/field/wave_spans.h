// SPDX-License-Identifier: GPL-3.0-or-later
// Stretches of both waves at the front end, and how large the waves are in them at most: where the largest
// forces need not be looked for.
#pragma once

#include <cstddef>
#include <vector>

#include "core/wave/field/rod_instants.h"
#include "core/wave/impact.h"

namespace drillwave {

// For the files of this folder only; of an impact solved with Detail::histories.

/// Where a span is cut in two.
enum class Cut {
    middle,
    front,  ///< behind its first part
    back,   ///< before its last part
};

/// Some neighbouring parts of a piece of both waves, between two instants.
struct WaveSpan {
    std::size_t piece = 0;
    int first = 0, last = 1;  ///< from the end of part number `first` to that of `last`
    PieceBends bends;         ///< of the piece, and into how many parts that is cut
    Instant begin, end;
    Cut cut = Cut::middle;

    bool isOnePart() const { return last - first == 1; }
};

/// Whether `next` begins where `span` ends, in the same piece.
inline bool follows(const WaveSpan& span, const WaveSpan& next) {
    return span.piece == next.piece && span.last == next.first;
}

/// What the waves, times `sign`, are at most in a span.
struct SpanBound {
    double incident = 0, reflected = 0;
};
SpanBound boundOf(const WaveSpan& span, double sign);

/// Where to cut a span that is wanted for one of its waves, times `sign`: where that is largest at an end of
/// the piece, and steep, all but the part there may soon be left out.
Cut cutForIncident(const WaveSpan& span, double sign);
Cut cutForReflected(const WaveSpan& span, double sign);

/// The pieces that end at `from` or later and begin until `until`, whole.
std::vector<WaveSpan> wholePieces(const Impact& impact, double from, double until);

/// All spans of more than one part in two, each where it is to be cut, in place of what is in `parts`.
void cut(const Impact& impact, const std::vector<WaveSpan>& spans, std::vector<WaveSpan>& parts);

/// The instants at their ends, each once, in order of time, in place of what is in `instants`.
void endsOf(const std::vector<WaveSpan>& spans, std::vector<Instant>& instants);

/// The largest of neighbouring numbers, in a time that grows like the logarithm of how many there are.
class RangeMaximum {
  public:
    void assign(const std::vector<double>& numbers);
    /// Of the numbers from `first` to before `behind`; minus infinity of none.
    double over(std::size_t first, std::size_t behind) const;

  private:
    std::size_t m_count = 0;
    std::vector<double> m_tree;  ///< m_count inner nodes, then the numbers
};

}  // namespace drillwave
