// SPDX-License-Identifier: GPL-3.0-or-later
// Position in the rod and time in the blow that the user has selected; all pages show them.
#pragma once

#include <QObject>
#include <optional>

namespace drillwave {

/// Position in the rod and time in the blow that the user has selected. The pages and the result panel share
/// them.
class Observation : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    /// Returns the selected position ξ = x/L: 0 (struck end) … 1 (bit); negative in the hammer of a drill
    /// string.
    double section() const { return m_section; }
    void setSection(double section);
    /// Returns the lowest selectable position x/L: 0, or for a hammer simulated by sections its rear end
    /// (negative).
    double rear() const { return m_rear; }
    void setRear(double rear);
    /// Returns the time of the time cursor, t/t0; nothing if there is none.
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
