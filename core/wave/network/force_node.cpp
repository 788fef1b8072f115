// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/force_node.h"

#include <algorithm>

namespace drillwave {

namespace {

/// Fa over a cell, and what the cell leaves out of it in the square.
struct ForceOverCell {
    WaveCell cell;
    double energy = 0;  ///< ∫Fa² dt [F0² t0]
};

ForceOverCell over(const PulseForce& force, double time, double width) {
    ForceOverCell result;
    if (!(width > 0)) return result;
    CellProjection projection;
    auto segment = std::ranges::upper_bound(force.segments, time, {}, &PulseSegment::start);
    if (segment != force.segments.begin()) --segment;
    for (; segment != force.segments.end() && segment->start < time + width; ++segment) {
        const double from = std::max(time, segment->start) - segment->start;
        const double to = std::min(time + width - segment->start, segment->length);
        if (to <= from) continue;
        const double offset = segment->start - time;
        projection.add((offset + from) / width, (offset + to) / width,
                       [&](double u) { return segment->forceAt(u * width - offset); });
        result.energy += segment->energyOf(from, to - from);
    }
    result.cell = projection.cell();
    return result;
}

}  // namespace

WaveCell ForceNode::step(const WaveCell& back, double time, double width) {
    const double end = time + width;
    if (time < m_force->end) {
        const auto [force, energy] = over(*m_force, time, width);
        m_now.record.impulse += width * force.mean();
        m_now.record.impulseMoment += width * (time * force.mean() + width * force.firstMoment());
        m_now.record.work += (energy - 2 * width * force.meanProduct(back)) / m_impedance;
        m_now.apart = m_now.released = end >= m_force->end;
        return force - back;
    }
    m_now.apart = m_now.released = true;
    return -1 * back;
}

}  // namespace drillwave
