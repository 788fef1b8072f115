// SPDX-License-Identifier: GPL-3.0-or-later
// Bit–rock law over time steps of constant force and velocity (paper, section 5.3; theory §6).
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "core/contact/contact_law.h"

namespace drillwave {

/// Contact of bit and rock in constant time steps Δ. The state is the gap, the force, and the largest force
/// so far.
///
/// In each step the force F is constant while the bit advances by dU = (2g − F)Δ, with the mean incident wave
/// g. F is chosen so that F·dU is the work of the law over that increment (T32),
///
///     F dU = ∫ F(U) dU,
///     F(U) of slope s_j β on the loading curve, β/γ below the largest force so far, 0 without contact,
///
/// even if the increment passes corners. On one line of slope a this gives F = f + (2g − f) q with
/// q = (aΔ/2)/(1 + aΔ/2) (T33). Here f is the force at the beginning of the step; there is no overshoot for
/// aΔ ≤ 2. If corners are passed, F is the root of a quadratic equation. It is unique, because the mean force
/// of the law grows with the increment while 2g − dU/Δ falls.
class StepLaw {
  public:
    /// Contact events within a time step, as bits that can be combined.
    enum Change : unsigned {
        none = 0,
        contact = 1,         ///< the gap closed, contact began
        unloading = 2,       ///< the force began to fall from the primary line, at the beginning of the step
        primaryLoading = 4,  ///< the force returned to the primary line
        separation = 8,      ///< the force became zero, contact ended
        corner = 16,         ///< the force passed one or more corners of the loading curve
    };

    /// Creates the contact of a bit with intact rock. `step` > 0 is the time step in t0, `gap` ≥ 0 the
    /// initial gap in I0/Z. While no wave arrives, a contact force up to `negligible` ≥ 0 (in units of F0) is
    /// set to zero.
    StepLaw(const ContactLaw<>& law, double step, double gap, double negligible);

    /// Advances by one time step with the mean incident wave g, in units of F0. Returns the contact force
    /// F ≥ 0 in the step, in units of F0.
    double advance(double g) {
        m_changes = none;
        if (!m_touches) {
            const double advance = 2 * g * m_step;
            if (advance > 0 && advance >= m_gap) return load(g);
            m_gap -= advance;
            return 0;
        }
        const double drive = 2 * g - m_force;
        if (std::abs(drive) <= rounding * (2 * std::abs(g) + m_force)) return rest(g);
        return drive > 0 ? advanceLoading(g, drive) : advanceUnloading(g, drive);
    }

    /// Returns the events in the last time step, as bits of the enumeration Change.
    unsigned changes() const { return m_changes; }
    /// Returns the fraction of the last step (0 to 1) at which the gap closed; valid only if changes() has
    /// `contact`.
    double contactFraction() const { return m_contactFraction; }
    /// Returns the fraction of the last step (0 to 1) at which the force reached the primary line (loading
    /// curve) again. It is valid only if changes() has `primaryLoading`.
    double primaryFraction() const { return m_primaryFraction; }
    /// Returns the fraction of the last step (0 to 1) at which the force became zero; valid only if changes()
    /// has `separation`.
    double separationFraction() const { return m_separationFraction; }
    /// Returns the fractions of the last step (0 to 1) at which corners were passed; valid only if changes()
    /// has `corner`.
    const std::vector<double>& cornerFractions() const { return m_cornerFractions; }

    /// Returns whether bit and rock are apart. Contact with exactly zero force is not apart.
    bool isApart() const { return !m_touches; }
    /// Returns the remaining gap between bit and rock, in units of I0/Z (hammer impulse over rod impedance).
    double gap() const { return m_gap; }
    /// Returns the contact force at the end of the last time step, in units of the mean hammer force F0.
    double force() const { return m_force; }
    /// Returns the largest contact force so far, in units of the mean hammer force F0.
    double peak() const { return m_law.largestForce(); }
    /// Sets the gap between bit and rock after free flight, in units of I0/Z.
    void setGap(double gap) { m_gap = gap; }

  private:
    static constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();

    double advanceLoading(double g, double drive) {
        const bool onPrimary = m_law.isElastic() || m_force >= peak();
        const double force = m_force + drive * (onPrimary ? m_loading : m_unloading);
        const double end = 2 * force - m_force;
        if (end > (onPrimary ? m_law.cornerForce() : peak())) return load(g);
        if (onPrimary) m_law.remember(end);
        m_force = end;
        return force;
    }
    double advanceUnloading(double g, double drive) {
        if (!m_law.isElastic() && m_force > 0 && m_force >= peak()) m_changes = unloading;
        const double force = m_force + drive * m_unloading;
        const double end = 2 * force - m_force;
        if (end < 0 || m_force == 0) return separate(g);
        m_force = end;
        return force;
    }
    double rest(double g) {
        if (g == 0 && m_force <= m_negligible) m_force = 0;
        return m_force;
    }
    double load(double g);
    void passCorner(double advance);
    double separate(double g);

    ContactLaw<> m_law;
    double m_step;
    double m_loading;    ///< q = (aΔ/2)/(1 + aΔ/2) with the slope a of the primary line
    double m_unloading;  ///< q = (aΔ/2)/(1 + aΔ/2) with the slope a of the elastic line
    double m_negligible;
    bool m_touches = false;
    double m_gap;
    double m_force = 0;
    unsigned m_changes = none;
    double m_contactFraction = 0, m_primaryFraction = 0, m_separationFraction = 0;
    std::vector<double> m_cornerFractions;
};

}  // namespace drillwave
