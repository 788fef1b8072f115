// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/job/observation.h"

#include <algorithm>

namespace drillwave {

void Observation::setSection(double section) {
    const double inside = std::clamp(section, m_rear, 1.0);
    if (m_section == inside) return;
    m_section = inside;
    emit sectionChanged(inside);
}

void Observation::setRear(double rear) {
    if (m_rear == rear) return;
    m_rear = rear;
    emit rearChanged(rear);
    setSection(m_section);
}

void Observation::setTime(std::optional<double> time) {
    if (m_time == time) return;
    m_time = time;
    emit timeChanged(time);
}

}  // namespace drillwave
