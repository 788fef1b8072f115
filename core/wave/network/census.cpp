// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/census.h"

#include <algorithm>
#include <cmath>

#include "core/numeric/gauss_rule.h"

namespace drillwave {

LineCensus::LineCensus(double from, double to, double decay, double before)
    : m_from(from), m_to(to), m_decay(decay) {
    const double length = std::min(to, 0.0) - std::min(from, 0.0);
    m_sums.entered = m_sums.present = length * before;
    m_sums.enteredSquare = m_sums.presentSquare = length * before * before;
}

/// A cell of which a part is in the line.
void LineCensus::addAcross(const WaveCell& cell, double start, double width) {
    const double from = std::clamp((m_from - start) / width, 0.0, 1.0);
    const double to = std::clamp((m_to - start) / width, 0.0, 1.0);
    if (from > 0) {
        const WaveCell gone = cell.part(0, from);
        m_sums.passed += from * width * gone.mean();
        m_sums.passedSquare += from * width * gone.meanSquare();
    }
    const double inside = (to - from) * width;
    const WaveCell part = from > 0 || to < 1 ? cell.part(from, to) : cell;
    m_sums.entered += inside * part.mean();
    m_sums.enteredSquare += inside * part.meanSquare();
    double more = 0, moreSquare = 0;  // than this part of the cell tells
    if (m_entered && m_entered->start == start) {
        const WaveCell told = cell.part(0, to);
        more = to * width * (m_entered->part.mean() - told.mean());
        moreSquare = to * width * (m_entered->part.meanSquare() - told.meanSquare());
    }
    m_sums.entered += more;
    m_sums.enteredSquare += moreSquare;
    if (m_decay == 0) {
        m_sums.present = m_sums.entered;
        m_sums.presentSquare = m_sums.enteredSquare;
        return;
    }
    m_sums.present += more;
    m_sums.presentSquare += moreSquare;
    const double rate = m_decay / (m_to - m_from);
    const GaussRule& rule = gaussRule();
    for (std::size_t i = 0; i < GaussRule::count; ++i) {
        const double age = m_to - (start + (from + (to - from) * rule.nodes[i]) * width);
        const double amplitude = part.value(rule.nodes[i]) * std::exp(-rate * age);
        m_sums.present += inside * rule.weights[i] * amplitude;
        m_sums.presentSquare += inside * rule.weights[i] * amplitude * amplitude;
    }
}

}  // namespace drillwave
