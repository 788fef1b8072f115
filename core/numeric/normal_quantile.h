// SPDX-License-Identifier: GPL-3.0-or-later
// Normal distribution: cumulative distribution function and its inverse.
#pragma once

namespace drillwave {

/// Returns the cumulative standard normal distribution at x, 0 … 1, with an absolute error of 1e-16.
double normalShare(double x);

/// Returns the x below which the share u of the standard normal distribution lies, 0 < u < 1. The error is
/// 1e-14 of max(1, |x|).
double normalQuantile(double u);

}  // namespace drillwave
