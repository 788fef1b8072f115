// SPDX-License-Identifier: GPL-3.0-or-later
// The normal distribution: share below a value, and back.
#pragma once

namespace drillwave {

/// Share of the standard normal distribution below x, 0 … 1, to 1e-16.
double normalShare(double x);

/// The x below which the share u of the standard normal distribution lies, 0 < u < 1, to 1e-14 of max(1,
/// |x|).
double normalQuantile(double u);

}  // namespace drillwave
