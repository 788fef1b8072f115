// SPDX-License-Identifier: GPL-3.0-or-later
// End of a stretch of contact.
#pragma once

namespace drillwave {

/// The end of a stretch of contact, as a representation of the waves sees it.
template <class Real>
struct StretchEnd {
    Real force = 0;    ///< F there, below zero by no more than rounding
    Real impulse = 0;  ///< bound of the error of the impulse of the blow, by rounding and cutting in it
    Real error = 0;    ///< what rounding and cutting in it do to the impulse of the blow, at most
};

}  // namespace drillwave
