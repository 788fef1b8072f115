// SPDX-License-Identifier: GPL-3.0-or-later
// The law of bit and rock over steps of constant force and velocity (paper, section 5.3; theory §6).
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "core/contact/contact_law.h"

namespace drillwave {

/// Contact of bit and rock in constant time steps: keeps its gap, its force and the largest force so far.
///
/// In each step the force F is constant while the front end advances by dU = (2g − F)Δ, with F such that F·dU
/// is the work of the law over that increment (T32),
///
///     F dU = ∫ F(U) dU,   F(U) of slope s_j β on the loading curve, β/γ below the largest force so far, 0
///     apart,
///
/// whatever corners the increment passes. On one line of slope a that is F = f + (2g − f) q,
/// q = (aΔ/2)/(1 + aΔ/2) (T33), where f is the force at the beginning of the step; it approaches the end of
/// the line without overshoot for aΔ ≤ 2. Along corners it is the root of a quadratic equation; it exists and
/// is the only one because the mean force of the law grows with the increment and 2g − dU/Δ falls.
class StepLaw {
  public:
    /// Events of a step, as bits: the corners that it passed.
    enum Change : unsigned {
        none = 0,
        contact = 1,         ///< the gap closed
        unloading = 2,       ///< the force turned down from the primary line, at the beginning of the step
        primaryLoading = 4,  ///< the force returned to the primary line
        separation = 8,      ///< the force vanished
        corner = 16,         ///< the force passed corners of the loading curve
    };

    /// Step Δ > 0 in t0, gap ≥ 0 in I0/Z; `negligible` ≥ 0 is the force taken for zero when nothing arrives
    /// any more.
    StepLaw(const ContactLaw<>& law, double step, double gap, double negligible);

    /// Advances by one step in which the mean incident wave is g. Returns F ≥ 0.
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

    unsigned changes() const { return m_changes; }  ///< of the last step
    /// Times in the last step when the gap closed, the primary line was reached, the force vanished; 0 … 1.
    double contactFraction() const { return m_contactFraction; }
    double primaryFraction() const { return m_primaryFraction; }
    double separationFraction() const { return m_separationFraction; }
    /// Returns the fractions of the last step (0 to 1) at which corners were passed; valid only if changes()
    /// has `corner`.
    const std::vector<double>& cornerFractions() const { return m_cornerFractions; }

    /// Returns whether it is not in contact; contact by exactly zero force counts as contact.
    bool isApart() const { return !m_touches; }
    double gap() const { return m_gap; }                  ///< still to close, I0/Z
    double force() const { return m_force; }              ///< at the end of the last step
    double peak() const { return m_law.largestForce(); }  ///< Fm
    /// Sets the gap that is left after free flight.
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
    double m_loading;    ///< q of the primary line
    double m_unloading;  ///< q below the largest force
    double m_negligible;
    bool m_touches = false;
    double m_gap;
    double m_force = 0;
    unsigned m_changes = none;
    double m_contactFraction = 0, m_primaryFraction = 0, m_separationFraction = 0;
    std::vector<double> m_cornerFractions;
};

}  // namespace drillwave
