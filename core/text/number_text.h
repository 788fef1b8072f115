// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers written as text in the C locale: exactly for files, rounded for people.
#pragma once

#include <charconv>
#include <string>

namespace drillwave {

/// Appends the shortest text that reads back as the same double, without allocation; nothing, an empty cell,
/// where there is no finite number.
void appendNumber(std::string& row, double value);

/// In that format with so many digits: of `scientific` and `fixed` behind the point, of `general` all that
/// count.
std::string numberText(double value, std::chars_format format, int digits);

/// With so many significant digits.
std::string rounded(double value, int digits = 6);

/// A bound in two digits that are not less than it.
std::string boundText(double bound);

}  // namespace drillwave
