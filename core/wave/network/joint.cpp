// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/joint.h"

namespace drillwave {

void Joint::step(const WaveCell* f1, const WaveCell* b2, WaveCell* b1, WaveCell* f2, std::size_t count,
                 std::size_t part, std::size_t parts) {
    if (m_mass > 0) {
        const double toVelocity = 2 / (m_impedance1 + m_impedance2);
        for (std::size_t i = 0; i < count; ++i, part = part + 1 == parts ? 0 : part + 1) {
            const WaveCell f = f1[i], b = m_passing * b2[i];
            const WaveCell v = m_maps[part].follow(toVelocity * (f - b), m_velocity);
            b1[i] = f - m_impedance1 * v;
            f2[i] = m_passing * (b + m_impedance2 * v);
        }
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
    setWidths({width});
    step(&f1, &b2, &b1, &f2, 1, 0, 1);
}

}  // namespace drillwave
