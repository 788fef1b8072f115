// SPDX-License-Identifier: GPL-3.0-or-later
// End of a stretch of contact.
#pragma once

namespace drillwave {

/// Result for one stretch of contact: the force at its end, the impulse and its error.
template <class Real>
struct StretchEnd {
    /// Impact force F at the end of the stretch of contact, in units of F0; negative only by rounding.
    Real force = 0;
    /// Impulse of the impact force over the stretch of contact, in units of I0.
    Real impulse = 0;
    /// Upper bound of the error of the blow's impulse due to rounding and truncation in this stretch of
    /// contact, in units of I0.
    Real error = 0;
};

}  // namespace drillwave
