// SPDX-License-Identifier: GPL-3.0-or-later
// End of a stretch of contact.
#pragma once

namespace drillwave {

/// Force, impulse and error at the end of a stretch of contact.
template <class Real>
struct StretchEnd {
    /// Impact force F at the end of the stretch, in units of F0; negative by rounding at most.
    Real force = 0;
    /// Impulse of the impact force over the stretch, in units of I0.
    Real impulse = 0;
    /// Upper bound of the error of the blow's impulse due to rounding and truncation in this stretch, in
    /// units of I0.
    Real error = 0;
};

}  // namespace drillwave
