// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/identify/chain_model.h"

#include <algorithm>
#include <cmath>

namespace drillwave {

double RockEnd::transitTime() const {
    double sum = 0;
    for (const EndSection& section : sections) sum += section.transitTime;
    return sum;
}

/// Waves enter with four zeros in front, so that nothing has to be asked of the index.
constexpr std::size_t leadingZeros = 4;

double ChainModel::arriving(const Line& line, const std::vector<double>& wave, std::size_t n) {
    if (n + leadingZeros < line.whole + 3) return 0;
    const double* at = wave.data() + (n + leadingZeros - line.whole);
    return line.passing * (line.weights[0] * at[-2] + line.weights[1] * at[-1] + line.weights[2] * at[0] +
                           line.weights[3] * at[1]);
}

void ChainModel::run(const RockEnd& end, const TrialRock& rock, const std::vector<double>& f,
                     std::size_t count, bool keepsRock) {
    m_returned.resize(count);
    if (keepsRock) {
        m_force.assign(count, 0);
        m_penetration.assign(count, 0);
    }
    m_largestForce = 0;
    const std::size_t sections = end.sections.size();
    m_lines.resize(sections);
    for (std::size_t j = 0; j < sections; ++j) {
        Line& line = m_lines[j];
        line.forward.assign(count + leadingZeros + 1, 0);
        line.backward.assign(count + leadingZeros + 1, 0);
        line.passing = end.sections[j].passing;
        const double delay = std::max(1.0, end.sections[j].transitTime / m_step);
        line.whole = static_cast<std::size_t>(delay);
        const double u = 1 - (delay - static_cast<double>(line.whole));  // from the earlier sample
        if (line.whole >= 2) {                                           // Catmull–Rom
            line.weights[0] = ((-0.5 * u + 1) * u - 0.5) * u;
            line.weights[1] = (1.5 * u - 2.5) * u * u + 1;
            line.weights[2] = ((-1.5 * u + 2) * u + 0.5) * u;
            line.weights[3] = (0.5 * u - 0.5) * u * u;
        } else {
            line.weights[0] = line.weights[3] = 0;
            line.weights[1] = 1 - u;
            line.weights[2] = u;
        }
    }
    m_velocities.assign(sections, 0);
    const double lastImpedance = sections ? end.sections.back().impedance : end.impedance;
    RockResponse response(rock, {lastImpedance, end.bitMass, end.barBehind}, m_step);
    double g = 0;
    for (std::size_t n = 0; n < count; ++n) {
        double forward = n < f.size() ? f[n] : 0;
        for (std::size_t j = 0; j < sections; ++j) {
            const double z1 = j ? end.sections[j - 1].impedance : end.impedance,
                         z2 = end.sections[j].impedance;
            const EndJoint& joint = end.joints[j];
            const double back = joint.passing * arriving(m_lines[j], m_lines[j].backward, n);
            double near, far;
            if (joint.mass > 0) {
                // M v' + (Z1 + Z2) v = 2(f − b): exact for what stays the same over the step
                const double rest = 2 * (forward - back) / (z1 + z2);
                const double part = -std::expm1(-(z1 + z2) / joint.mass * m_step);
                m_velocities[j] += part * (rest - m_velocities[j]);
                near = forward - z1 * m_velocities[j];
                far = back + z2 * m_velocities[j];
            } else {
                const double turned = (z2 - z1) / (z1 + z2) * (forward - back);
                near = back + turned;
                far = forward + turned;
            }
            if (j)
                m_lines[j - 1].backward[n + leadingZeros] = near;
            else
                m_returned[n] = near;
            m_lines[j].forward[n + leadingZeros] = joint.passing * far;
            forward = arriving(m_lines[j], m_lines[j].forward, n);
        }
        response.advance(g, forward);
        g = forward;
        const double back = response.reflected(g);
        if (sections)
            m_lines[sections - 1].backward[n + leadingZeros] = back;
        else
            m_returned[n] = back;
        m_largestForce = std::max(m_largestForce, response.force());
        if (keepsRock) {
            m_force[n] = response.force();
            m_penetration[n] = response.penetration();
        }
    }
    m_lastForce = response.force();
}

}  // namespace drillwave
