// SPDX-License-Identifier: GPL-3.0-or-later
// The signs of print, which a terminal and the scripts that read its bytes do without.
#pragma once

#include <string>
#include <string_view>

#include "core/text/handy_text.h"

namespace drillwave {

/// "µs", "µm", "mm²" and "kg/m³" for the name of a unit, or for a value with its unit.
std::string printedUnit(std::string_view text);

/// A number with a minus, and with its power of ten: "−0.4", "3.4·10⁻¹⁴" for "3.4e-14".
std::string printedNumber(std::string_view text);

/// Words with "…", "±", "≥" and "d₀" for "...", "+-", ">=" and "d0", and with Greek letters for "tau".
std::string printedWords(std::string_view text);

/// The style of a reader with the signs of print, and so in the words of a page: isPrinted().
class PrintedStyle : public ReadingStyle {
  public:
    /// Must not outlive the style of the reader.
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
