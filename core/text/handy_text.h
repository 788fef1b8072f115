// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and words as people read them, numbers rounded and in a unit that fits: never for files that are
// read back.
#pragma once

#include <charconv>
#include <string>
#include <string_view>

#include "core/text/message.h"
#include "core/text/units.h"

namespace drillwave {

// Numbers written as text in the C locale: exactly for files, rounded for people.

/// Appends the shortest text that reads back as the same double, without allocation; nothing, an empty cell,
/// where there is no finite number.
void appendNumber(std::string& row, double value);

/// In that format with so many digits: of `scientific` and `fixed` behind the point, of `general` all that
/// count.
std::string numberText(double value, std::chars_format format, int digits);

/// Returns a number with that many significant digits.
std::string rounded(double value, int digits = 6);

/// Direction of rounding.
enum class Rounding { nearest, up, down };

/// With at most so many significant digits, `up` not less than it was and `down` not more but for rounding
/// noise: 0.3 stays 0.3. `nearest` leaves the rounding to the text.
double roundedTo(double value, int digits, Rounding rounding);

/// A unit in which a value is read, and its name as it is shown.
struct ReadUnit {
    const Unit* unit = nullptr;
    std::string name;
};

/// How a reader has sentences and tables written: here in English, in the C locale and in SI, as the commands
/// do; a window has styles of its own.
class ReadingStyle {
  public:
    ReadingStyle() = default;
    ReadingStyle(const ReadingStyle&) = delete;
    ReadingStyle& operator=(const ReadingStyle&) = delete;
    virtual ~ReadingStyle() = default;

    /// Returns a number with that many significant digits.
    virtual std::string number(double value, int digits = 6) const { return rounded(value, digits); }
    /// Returns an error, of which the power of ten matters: "3.2e-16".
    virtual std::string magnitude(double value) const;
    /// Returns the unit of its usual family that needs the fewest zeros.
    virtual ReadUnit unitFor(double si, Quantity quantity) const;
    /// Returns the same for a penetration rate, which drillers count per minute.
    virtual ReadUnit rateUnit(double si) const;
    /// Returns whether texts are only for people, in a window or on a page: with the signs of print, and with
    /// pages of the window instead of commands.
    virtual bool isPrinted() const { return false; }
    /// Returns whether tables show values as a file gives them.
    virtual bool keepsUnitsOfFile() const { return true; }
    /// Returns the title of a column of values with their units.
    virtual Message unitsTitle() const { return translatable("in SI"); }
    /// Returns the pattern of a Message in the language of the reader.
    virtual std::string patternFor(const std::string& english) const { return english; }
    /// Returns that language, ISO 639.
    virtual std::string language() const { return "en"; }

    /// Returns the sentence in the language of the reader.
    std::string said(const Message& message) const;
    /// Returns an SI value in the unit that suits it, rounded: "71.7 kN", "3.2 mm", "105 MN/m"; a ratio as
    /// the bare number.
    std::string quantity(double si, Quantity quantity, int digits = 6,
                         Rounding rounding = Rounding::nearest) const;
    /// Returns a penetration rate in the same way.
    std::string rate(double si, int digits = 6) const;
    /// Returns a bound in two digits, not below its value.
    std::string bound(double bound) const;
    /// Returns numbers written in the C locale with the decimal sign of the reader.
    std::string withDecimalSign(std::string cText) const;
    /// A share as "+10.3 %" or "-5 %".
    std::string signedPercent(double share) const;
    /// The name of a value of an enumeration, "half_sine", in the words of the reader: "half sine" in print.
    std::string name(std::string_view name) const;

  private:
    std::string inUnit(double si, const ReadUnit& read, int digits, Rounding rounding) const;
};

/// Returns the style of the commands.
const ReadingStyle& plainStyle();

/// Returns an SI value in that style.
std::string inHandyUnit(double si, Quantity quantity, int digits = 6);

}  // namespace drillwave
