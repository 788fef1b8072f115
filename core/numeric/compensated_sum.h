// SPDX-License-Identifier: GPL-3.0-or-later
// A sum that keeps what rounding drops.
#pragma once

#include <cmath>

namespace drillwave {

/// Neumaier's sum: times and impulses of many thousand pieces stay exact to the last digit.
template <class Real>
class CompensatedSum {
  public:
    CompensatedSum& operator=(Real value) {
        m_sum = value;
        m_lost = 0;
        return *this;
    }
    CompensatedSum& operator+=(Real term) {
        const Real sum = m_sum + term;
        const Real added = sum - m_sum;  // no branch for the larger of the two: it would be guessed wrong
        m_lost += (m_sum - (sum - added)) + (term - added);
        m_sum = sum;
        return *this;
    }
    operator Real() const { return m_sum + m_lost; }

  private:
    Real m_sum = 0;
    Real m_lost = 0;
};

}  // namespace drillwave
