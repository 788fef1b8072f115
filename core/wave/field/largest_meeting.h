// SPDX-License-Identifier: GPL-3.0-or-later
// The largest force that both waves make together while a blow lasts, and where little of them must be looked
// at for it.
#pragma once

#include <cstddef>
#include <vector>

#include "core/wave/field/rod_instants.h"
#include "core/wave/field/wave_spans.h"
#include "core/wave/impact.h"

namespace drillwave {

// For the files of this folder only; of an impact solved with Detail::histories.

/// The largest of one sign of the force in the rod, as recorded times of the two waves that make it.
struct Meeting {
    double size = 0;  ///< [F0], ≥ 0
    double incident = 0, reflected = 0;

    void offer(double sum, const Instant& incoming, const Instant& back) {
        if (sum > size) *this = {sum, incoming.time, back.time};
    }
};

/// The largest sum of one sign while the blow lasts. Almost all of both waves cannot be part of it: from
/// whole pieces to parts of them, what cannot come to the largest sum that was seen so far with anything that
/// it meets is left out. What is left is looked at in every part. Keeps its memory from one sign to the
/// other.
class LargestMeeting {
  public:
    explicit LargestMeeting(const Impact& impact);

    /// Of −N for a sign of 1, of N for one of −1. `pieces` are whole, `ends` those of them.
    Meeting find(double sign, const std::vector<WaveSpan>& pieces, const std::vector<Instant>& ends);
    /// Spans so far.
    long looked() const { return m_looked; }

  private:
    Meeting sumsOf(const std::vector<Instant>& instants);
    void addInTheBlow(const std::vector<Instant>& instants, Meeting& most);
    void addLast(const std::vector<Instant>& instants, Meeting& most) const;
    bool areInRod(const Instant& incoming, const Instant& reflected) const;
    void addCounterparts(const WaveSpan& span, std::vector<Instant>& instants) const;
    const std::vector<Instant>& instantsOf(const std::vector<WaveSpan>& spans);
    void keep(const std::vector<WaveSpan>& spans, double least);
    void sortOut(const std::vector<WaveSpan>& spans, double least);
    double rounding(const WaveSpan& span) const;
    std::size_t firstEndingAt(double time) const;
    std::size_t firstBeginningAfter(double time) const;
    std::size_t behindMet(std::size_t i) const;
    double lastToMeet(const WaveSpan& span) const;

    const Impact& m_impact;
    double m_end;      ///< of the blow, recorded time
    Instant m_before;  ///< what was in the rod before the first front
    double m_sign = 1;
    long m_looked = 0;

    std::vector<WaveSpan> m_left, m_parts;  ///< what may be part of the sum, and that in parts
    std::vector<Instant> m_instants;
    std::vector<Instant> m_back;  ///< from somewhere on falling values of the reflected wave
    std::vector<SpanBound> m_bounds;
    std::vector<const WaveSpan*> m_some;  ///< what is not sorted out by the largest of all
    std::vector<double> m_incident, m_reflected;
    RangeMaximum m_mostIncident, m_mostReflected;
};

}  // namespace drillwave
