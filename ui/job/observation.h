// SPDX-License-Identifier: GPL-3.0-or-later
// Place in the rod and time in the blow that the user looks at: the same on every page.
#pragma once

#include <QObject>
#include <optional>

namespace drillwave {

/// The section and the time cursor that pages and result panel share.
class Observation : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    /// ξ = x/L, 0 (struck end) … 1 (bit); below 0 in the hammer of a drill string.
    double section() const { return m_section; }
    void setSection(double section);
    /// The least that it can be: 0, or where the rear of the hammer is.
    double rear() const { return m_rear; }
    void setRear(double rear);
    /// Global time of the time cursor t/t0; nothing while there is none.
    std::optional<double> time() const { return m_time; }
    void setTime(std::optional<double> time);

  signals:
    void sectionChanged(double section);
    void rearChanged(double rear);
    void timeChanged(std::optional<double> time);

  private:
    double m_section = 0.5;
    double m_rear = 0;
    std::optional<double> m_time;
};

}  // namespace drillwave
