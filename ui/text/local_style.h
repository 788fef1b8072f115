// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences and tables of the core in the words, numbers and units of the one at the window.
#pragma once

#include <QLocale>
#include <optional>

#include "core/text/handy_text.h"
#include "ui/text/unit_kind.h"

namespace drillwave {

class UnitChoice;

/// Words in the language that is spoken, numbers as numberText() writes them, in SI or US units or those
/// chosen by kind.
class LocalStyle : public ReadingStyle {
  public:
    /// `system` is taken as SI where it is dimensionless: what is told in sentences has no other unit.
    LocalStyle(const QLocale& locale, UnitSystem system, ChosenUnits chosen);

    /// Of the one at the window as it is now: QLocale() and what is chosen there.
    static LocalStyle of(const UnitChoice& units);

    std::string number(double value, int digits) const override;
    ReadUnit unitFor(double si, Quantity quantity) const override;
    ReadUnit rateUnit(double si) const override;
    bool isPrinted() const override { return true; }
    bool keepsUnitsOfFile() const override { return false; }
    Message unitsTitle() const override;
    std::string patternFor(const std::string& english) const override;
    std::string language() const override;

  private:
    ReadUnit unitOf(std::optional<UnitKind> kind, double si, Quantity quantity) const;

    QLocale m_locale;
    UnitSystem m_system;
    ChosenUnits m_chosen;
};

}  // namespace drillwave
