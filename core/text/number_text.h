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

/// To which side digits are left out.
enum class Rounding { nearest, up, down };

/// With at most so many significant digits, `up` not less than it was and `down` not more but for rounding
/// noise: 0.3 stays 0.3. `nearest` leaves the rounding to the text.
double roundedTo(double value, int digits, Rounding rounding);

}  // namespace drillwave
