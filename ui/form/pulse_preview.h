// SPDX-License-Identifier: GPL-3.0-or-later
// A small drawing of the force of the hammer over time.
#pragma once

#include <QPolygonF>
#include <QWidget>

#include "core/model/pulse_force.h"
#include "core/model/scenario.h"

namespace drillwave {

class UnitChoice;

// The force of the hammer over time as a line to draw, whatever the pulse.

/// Time in t0 from 0 to `end`, force relative to its peak. At most a few thousand points, the extremes of a
/// longer table kept. Pulses without end are shown until little is left of them; empty without a force.
struct PulseCurve {
    QPolygonF points;
    double end = 0;

    explicit PulseCurve(const PulseForce& force);
};

/// Names the peak of the force and the time t0, in physical units where the scenario has them.
class PulsePreview : public QWidget {
    Q_OBJECT

  public:
    /// The units must outlive it.
    explicit PulsePreview(const UnitChoice& units, QWidget* parent = nullptr);

    void present(const Scenario& scenario);
    /// The drawing in words: "rectangular, 200 µs, 255 kN".
    QString words() const { return m_words; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QString peakText(double peak, const Scenario& scenario) const;

    const UnitChoice& m_units;
    QPolygonF m_curve;  // time in t0, force relative to the peak
    double m_end = 0;   // of the curve, in t0
    QString m_peakText;
    QString m_timeText;
    QString m_words;
};

/// "half sine", as people write it.
QString shapeText(PulseShape shape);

}  // namespace drillwave
