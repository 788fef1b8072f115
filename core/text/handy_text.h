// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and words as people read them: numbers are rounded and have a unit that suits their size. Not for
// files that the program reads back.
#pragma once

#include <charconv>
#include <string>
#include <string_view>

#include "core/text/message.h"
#include "core/text/units.h"

namespace drillwave {

// Numbers written as text in the C locale: exactly for files, rounded for people.

/// Appends a number as the shortest text that reads back as the same double, without allocating memory.
/// Appends nothing for infinity or NaN, which leaves a cell empty.
void appendNumber(std::string& row, double value);

/// Returns a number in this format, "–" if it is infinite or NaN. `digits` counts decimals for `scientific`
/// and `fixed`, significant digits for `general`.
std::string numberText(double value, std::chars_format format, int digits);

/// Returns a number as text with this many significant digits, without trailing zeros; "–" if it is infinite
/// or NaN.
std::string rounded(double value, int digits = 6);

/// Direction of rounding.
enum class Rounding { nearest, up, down };

/// Returns a number rounded up or down to this many significant digits. For `nearest` the number is returned
/// unchanged. Rounding noise of 1e-12 is ignored: 0.3 remains 0.3.
double roundedTo(double value, int digits, Rounding rounding);

/// Unit in which a value is shown, and the name of the unit on the screen or page.
struct ReadUnit {
    const Unit* unit = nullptr;
    std::string name;
};

/// Format of numbers, units and sentences for one kind of reader. This class writes English, the C locale and
/// SI units, as the commands do; windows and pages override it.
class ReadingStyle {
  public:
    ReadingStyle() = default;
    ReadingStyle(const ReadingStyle&) = delete;
    ReadingStyle& operator=(const ReadingStyle&) = delete;
    virtual ~ReadingStyle() = default;

    /// Returns a number as text with this many significant digits and the decimal sign of the reader.
    virtual std::string number(double value, int digits = 6) const { return rounded(value, digits); }
    /// Returns an error as text in scientific notation with two significant digits: "3.2e-16".
    virtual std::string magnitude(double value) const;
    /// Returns the most readable unit for a value given in SI: the largest common unit of the quantity in
    /// which the value is at least 1.
    virtual ReadUnit unitFor(double si, Quantity quantity) const;
    /// Returns the most readable unit for a penetration rate given in m/s; by default m/min, as is usual in
    /// drilling.
    virtual ReadUnit rateUnit(double si) const;
    /// Returns whether texts are for a window or a printed page; false for a terminal. Texts for windows and
    /// pages have typographic signs (−, µ, ≥) and refer to pages of the program window instead of commands.
    virtual bool isPrinted() const { return false; }
    /// Returns whether tables show an input exactly as it is in the scenario file, with the unit used there.
    /// If false, tables show inputs in the units of unitFor().
    virtual bool keepsUnitsOfFile() const { return true; }
    /// Returns the title of a table column that shows values with their units: "in SI".
    virtual Message unitsTitle() const { return translatable("in SI"); }
    /// Returns the translation of an English sentence pattern of a Message ("%1: cannot be written"); by
    /// default the pattern unchanged.
    virtual std::string patternFor(const std::string& english) const { return english; }
    /// Returns the language of the texts as its ISO 639 code, such as "en".
    virtual std::string language() const { return "en"; }

    /// Returns a message as a sentence in the language of the reader.
    std::string said(const Message& message) const;
    /// Returns a value given in SI as rounded text with a suitable unit: "71.7 kN", "3.2 mm", "105 MN/m". A
    /// ratio has no unit.
    std::string quantity(double si, Quantity quantity, int digits = 6,
                         Rounding rounding = Rounding::nearest) const;
    /// Returns a penetration rate, given in m/s, as rounded text with its unit: "1.25 m/min".
    std::string rate(double si, int digits = 6) const;
    /// Returns an upper bound of an error as text with two digits. The bound is enlarged by 5 %, so that
    /// rounding cannot make it too small.
    std::string bound(double bound) const;
    /// Returns the text with each decimal point, as in the C locale, replaced by the decimal sign of the
    /// reader.
    std::string withDecimalSign(std::string cText) const;
    /// Returns a share, such as 0.103, in per cent with its sign: "+10.3 %", "-5 %".
    std::string signedPercent(double share) const;
    /// Returns the name of a value of an enumeration in the language of the reader. Windows and pages get
    /// "half sine" for "half_sine".
    std::string name(std::string_view name) const;

  private:
    std::string inUnit(double si, const ReadUnit& read, int digits, Rounding rounding) const;
};

/// Returns the format of the commands: English, the C locale and SI units.
const ReadingStyle& plainStyle();

/// Returns a value given in SI as the commands print it, rounded and with a suitable unit: "71.7 kN".
std::string inHandyUnit(double si, Quantity quantity, int digits = 6);

}  // namespace drillwave
