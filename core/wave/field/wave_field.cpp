// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/wave_field.h"

#include <cassert>

#include "core/wave/field/bit_history.h"

namespace drillwave {

double WaveField::impactForce(double t) const {
    assert(m_impact->hasHistories());
    return drillwave::impactForce(*m_impact, t - arrival());
}

double WaveField::impactImpulse(double t) const {
    assert(m_impact->hasHistories());
    return drillwave::impactImpulse(*m_impact, t - arrival());
}

double WaveField::positiveWave(double xi, double t) const {
    assert(m_impact->hasHistories());
    return -incidentWave(*m_impact, m_delays.atBit(Heading::toBit, xi, t));
}

double WaveField::negativeWave(double xi, double t) const {
    assert(m_impact->hasHistories());
    const double s = m_delays.atBit(Heading::fromBit, xi, t);
    return -(drillwave::impactForce(*m_impact, s) - incidentWave(*m_impact, s));
}

double WaveField::force(double xi, double t) const {
    return positiveWave(xi, t) + negativeWave(xi, t);
}

double WaveField::velocity(double xi, double t) const {
    return negativeWave(xi, t) - positiveWave(xi, t);
}

}  // namespace drillwave
