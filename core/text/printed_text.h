// SPDX-License-Identifier: GPL-3.0-or-later
// Typographic signs (−, µ, ≥) for windows and pages. Terminals and scripts get ASCII instead.
#pragma once

#include <string>
#include <string_view>

#include "core/text/handy_text.h"

namespace drillwave {

/// Returns the name of a unit, or a value with its unit, in typographic signs: "µs", "mm²" and "kg/m³" for
/// "us", "mm^2" and "kg/m^3".
std::string printedUnit(std::string_view text);

/// Returns the text of a number with a minus sign and a written power of ten: "−0.4" for "-0.4", "3.4·10⁻¹⁴"
/// for "3.4e-14".
std::string printedNumber(std::string_view text);

/// Returns a sentence in typographic signs: "…", "±", "≥" and "d₀" for "...", "+-", ">=" and "d0", and "τ"
/// for "tau".
std::string printedWords(std::string_view text);

/// Format of texts in windows and on pages. It takes each text from another format, and puts typographic
/// signs (−, µ, ≥) into it.
class PrintedStyle : public ReadingStyle {
  public:
    /// Takes the format whose texts get typographic signs. It must outlive this object.
    explicit PrintedStyle(const ReadingStyle& reader) : m_reader(reader) {}

    std::string number(double value, int digits = 6) const override;
    ReadUnit unitFor(double si, Quantity quantity) const override;
    ReadUnit rateUnit(double si) const override;
    bool keepsUnitsOfFile() const override { return m_reader.keepsUnitsOfFile(); }
    bool isPrinted() const override { return true; }
    Message unitsTitle() const override { return m_reader.unitsTitle(); }
    std::string patternFor(const std::string& english) const override;
    std::string language() const override { return m_reader.language(); }

  private:
    const ReadingStyle& m_reader;
};

}  // namespace drillwave
