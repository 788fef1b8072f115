// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/joint.h"

namespace drillwave {

void Joint::stepMass(const Relaxation& map, const WaveCell& f1, const WaveCell& b2, WaveCell& b1,
                     WaveCell& f2) {
    const WaveCell f = f1, b = m_passing * b2;
    const WaveCell v = map.follow(m_toVelocity * (f - b), m_velocity);
    b1 = f - m_impedance1 * v;
    f2 = m_passing * (b + m_impedance2 * v);
}

void Joint::step(const WaveCell* f1, const WaveCell* b2, WaveCell* b1, WaveCell* f2, std::size_t count,
                 std::size_t part, std::size_t parts) {
    if (m_mass > 0) {
        for (std::size_t i = 0; i < count; ++i, part = part + 1 == parts ? 0 : part + 1)
            stepMass(m_maps[part], f1[i], b2[i], b1[i], f2[i]);
        return;
    }
    const double r = reflection(), passing = m_passing;
    // In arrays of their own the four coefficients are worked on side by side.
    using Coefficients = std::array<double, WaveCell::count>;
    if (passing == 1) {
        for (std::size_t i = 0; i < count; ++i) {
            const Coefficients f = f1[i].c, b = b2[i].c;
            Coefficients turned;
            for (int k = 0; k < WaveCell::count; ++k) turned[k] = r * (f[k] - b[k]);
            for (int k = 0; k < WaveCell::count; ++k) b1[i].c[k] = b[k] + turned[k];
            for (int k = 0; k < WaveCell::count; ++k) f2[i].c[k] = f[k] + turned[k];
        }
        return;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const Coefficients f = f1[i].c, b = b2[i].c;
        Coefficients weakened, turned;
        for (int k = 0; k < WaveCell::count; ++k) weakened[k] = passing * b[k];
        for (int k = 0; k < WaveCell::count; ++k) turned[k] = r * (f[k] - weakened[k]);
        for (int k = 0; k < WaveCell::count; ++k) b1[i].c[k] = weakened[k] + turned[k];
        for (int k = 0; k < WaveCell::count; ++k) f2[i].c[k] = passing * (f[k] + turned[k]);
    }
}

void Joint::stepAlone(const WaveCell& f1, const WaveCell& b2, double width, WaveCell& b1, WaveCell& f2) {
    stepMass(Relaxation(rate() * width), f1, b2, b1, f2);
}

}  // namespace drillwave
