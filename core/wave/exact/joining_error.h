// SPDX-License-Identifier: GPL-3.0-or-later
// What joined wave pieces do to the impulse of the rock, through the events that fall into them.
#pragma once

#include <algorithm>

#include "core/wave/exact/joining_budget.h"
#include "core/wave/impact.h"

namespace drillwave {

/// Sums up what joining does to e. The force depends on the way of the bit and on the largest one before. The
/// way is displaced inside a joined piece only, by D there; but a peak inside keeps D for ever: until the
/// primary line is reached again the force errs by (β/γ) 2D, at most, and by no more than 2D in impulse after
/// each change, as F follows the wave.
///
/// An impulse displaced before the last peak changes the energy that is stored there, of which the rod gets
/// the share γ: it counts √γ times. Those after it count in full.
template <class Real>
class JoiningError {
  public:
    /// `fastest` is the larger rate of the contact, β/γ.
    void begin(const JoiningBudget& budget, Real fastest) {
        m_fastest = fastest;
        m_loadingWeight = Real(budget.loadingWeight);
        m_loading = m_rebound = m_peak = 0;
    }

    /// `length` of elastic line has passed.
    void passElastic(Real length) { m_rebound += displacedBy(m_peak, length); }

    /// An event in a piece of wave that is displaced by `displaced`, of which `length` is not passed yet.
    void pass(ContactEvent event, Real displaced, Real length) {
        m_rebound += displacedBy(displaced, length);
        if (event == ContactEvent::unloading) m_peak = displaced;
        if (event == ContactEvent::primaryLoading) {
            m_loading += m_rebound;
            m_rebound = 0;
        }
    }

    /// Of e. Errors are up to half of the plain sum (tst_joining), and the bound four times that.
    Real bound() const { return 4 * (m_rebound + m_loadingWeight * m_loading); }

  private:
    /// The impulse that a displaced way of the bit displaces while the force follows it for `length`.
    Real displacedBy(Real way, Real length) const { return 2 * way * std::min(Real(1), m_fastest * length); }

    Real m_fastest = 0;        ///< β/γ
    Real m_loadingWeight = 1;  ///< √γ
    Real m_loading = 0;        ///< impulse displaced before the last return to the primary line, I0
    Real m_rebound = 0;        ///< and since then
    Real m_peak = 0;           ///< displacement of the largest way of the bit, I0
};

}  // namespace drillwave
