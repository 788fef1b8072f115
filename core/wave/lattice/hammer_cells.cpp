// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/lattice/hammer_cells.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace drillwave {

HammerCells::HammerCells(const PulseForce& pulse, double step)
    : m_pulse(&pulse), m_step(step), m_ended(pulse.segments.empty()) {
    assert(step > 0);
}

double HammerCells::segmentEnd() const {
    const PulseSegment& segment = m_pulse->segments[m_segment];
    return segment.start + segment.length;
}

double HammerCells::nextMean() {
    const double from = m_count * m_step;
    const double to = (m_count + 1) * m_step;
    ++m_count;
    // Ends of steps and of segments that coincide but for rounding are the same.
    const double coincident = 4 * std::numeric_limits<double>::epsilon() * to;
    while (segmentEnd() <= from + coincident)
        if (++m_segment == m_pulse->segments.size()) {
            m_ended = true;
            return 0;
        }
    const PulseSegment& segment = m_pulse->segments[m_segment];
    if (segment.kind == PulseSegment::Kind::linear && to <= segmentEnd() + coincident)
        return std::max(0.0, segment.value + segment.slope * (from + m_step / 2 - segment.start));
    return std::max(0.0, (m_pulse->impulseUntil(to) - m_pulse->impulseUntil(from)) / m_step);
}

}  // namespace drillwave
