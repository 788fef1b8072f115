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
    const double r = reflection();
    for (std::size_t i = 0; i < count; ++i) {
        const WaveCell f = f1[i], b = b2[i];
        if (m_passing == 1) {
            for (int k = 0; k < WaveCell::count; ++k) {
                const double turned = r * (f.c[k] - b.c[k]);
                b1[i].c[k] = b.c[k] + turned;
                f2[i].c[k] = f.c[k] + turned;
            }
        } else {
            for (int k = 0; k < WaveCell::count; ++k) {
                const double weakened = m_passing * b.c[k];
                const double turned = r * (f.c[k] - weakened);
                b1[i].c[k] = weakened + turned;
                f2[i].c[k] = m_passing * (f.c[k] + turned);
            }
        }
    }
}

double Joint::velocityWithin(const WaveCell& f1, const WaveCell& b2, double width, double share) const {
    const WaveCell target = (2 / (m_impedance1 + m_impedance2)) * (f1 - m_passing * b2);
    double velocity = m_velocity;
    if (share > 0) Relaxation(rate() * width * share).follow(target.part(0, share), velocity);
    return velocity;
}

}  // namespace drillwave
