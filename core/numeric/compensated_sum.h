// SPDX-License-Identifier: GPL-3.0-or-later
// Summation without accumulated rounding errors.
#pragma once

#include <cmath>

namespace drillwave {

/// Sum of floating-point numbers by Neumaier's method, which also adds up the rounding errors. Sums of many
/// thousand terms are exact to the last digit.
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
        // no branch that selects the larger number: the processor would often predict it wrongly
        const Real added = sum - m_sum;
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
