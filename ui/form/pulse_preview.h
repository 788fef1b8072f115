// SPDX-License-Identifier: GPL-3.0-or-later
// Small plot of the hammer force over time.
#pragma once

#include <QPolygonF>
#include <QWidget>

#include "core/model/pulse_force.h"
#include "core/model/scenario.h"

namespace drillwave {

class UnitChoice;

// Curve of the hammer force over time, ready to be drawn, for any pulse shape.

/// Curve of the hammer force: time in units of t0 from 0 to `end`, force relative to its peak. It has at most
/// a few thousand points; longer tables are thinned, but keep their extremes. A pulse of infinite length is
/// cut where little of its force remains. Empty without a force.
struct PulseCurve {
    QPolygonF points;
    double end = 0;

    explicit PulseCurve(const PulseForce& force);
};

/// Plot of the hammer force over time, labelled with its peak and t0, in physical units if the scenario has
/// them.
class PulsePreview : public QWidget {
    Q_OBJECT

  public:
    /// Makes an empty plot. `units` must outlive it.
    explicit PulsePreview(const UnitChoice& units, QWidget* parent = nullptr);

    void present(const Scenario& scenario);
    /// Returns a description of the plot for screen readers: "rectangular, 200 µs, 255 kN".
    QString words() const { return m_words; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QString peakText(double peak, const Scenario& scenario) const;

    const UnitChoice& m_units;
    QPolygonF m_curve;  // points of the curve: time in t0, force relative to its peak
    double m_end = 0;   // end of the curve, in t0
    QString m_peakText;
    QString m_timeText;
    QString m_words;
};

/// Returns the translated name of a pulse shape: "half sine".
QString shapeText(PulseShape shape);

}  // namespace drillwave
