// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/history_reader.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/numeric/stride_search.h"

namespace drillwave {

double recordedTime(const Impact& impact, double s) {
    double leftOut = 0;
    for (const PeriodSkip& skip : impact.skips) {
        if (s < skip.start) break;
        if (s < skip.start + skip.duration)
            return skip.start - leftOut - impact.roundTrip + std::fmod(s - skip.start, impact.roundTrip);
        leftOut += skip.duration;
    }
    s -= leftOut;
    const double end = impact.incident.end();
    if (s >= end && impact.roundTrip > 0)
        return end - impact.roundTrip + std::fmod(s - end, impact.roundTrip);
    return s;
}

double uninterrupted(const Impact& impact, double s) {
    for (const PeriodSkip& skip : impact.skips) {
        if (s < skip.start) return skip.start - s;
        const double end = skip.start + skip.duration;
        if (s < end) return std::min(end - s, impact.roundTrip - std::fmod(s - skip.start, impact.roundTrip));
    }
    return impact.incident.end() - recordedTime(impact, s);
}

double unrecordedBefore(const Impact& impact, double recorded) {
    double leftOut = 0;
    for (const PeriodSkip& skip : impact.skips) {
        if (recorded + leftOut < skip.start) break;
        leftOut += skip.duration;
    }
    return leftOut;
}

double waveBeforeArrival(const Impact& impact) {
    return impact.frontArrival == 0 && impact.roundTrip > 0 ? 1 / impact.roundTrip : 0.0;
}

HistoryReader::HistoryReader(const Impact& impact) : m_impact(impact), m_before(waveBeforeArrival(impact)) {
    assert(impact.hasHistories());
}

double HistoryReader::incident(double s) {
    if (s < 0) return m_before;
    if (!seek(s)) return 0;
    return m_impact.incident.value(m_impact.incident.pieces()[m_index], m_local);
}

double HistoryReader::reflected(double s) {
    if (s < 0) return -m_before;
    if (!seek(s)) return 0;
    return m_impact.force.value(m_impact.force.pieces()[m_index], m_local) -
           m_impact.incident.value(m_impact.incident.pieces()[m_index], m_local);
}

// The incident wave and the force are recorded on the same pieces.
bool HistoryReader::seek(double s) {
    const auto pieces = m_impact.incident.pieces();
    const double recorded = recordedTime(m_impact, s);
    if (pieces.empty() || !(recorded >= pieces.front().start) || recorded >= m_impact.incident.end())
        return false;
    ++m_steps;
    if (!holds(m_index, recorded)) m_index = find(recorded);
    m_local = std::min(recorded - pieces[m_index].start, pieces[m_index].length);
    return true;
}

bool HistoryReader::holds(std::size_t index, double recorded) const {
    const auto pieces = m_impact.incident.pieces();
    return recorded >= pieces[index].start &&
           (index + 1 == pieces.size() || recorded < pieces[index + 1].start);
}

std::size_t HistoryReader::find(double recorded) {
    const auto pieces = m_impact.incident.pieces();
    return strideSearch(m_index, pieces.size(), [&](std::size_t index) {
        ++m_steps;
        return pieces[index].start <= recorded;
    });
}

}  // namespace drillwave
