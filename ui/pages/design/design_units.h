// SPDX-License-Identifier: GPL-3.0-or-later
// Units and names in which a design study is shown in the window and in pictures.
#pragma once

#include <QLocale>
#include <QString>
#include <functional>

#include "core/report/design_words.h"
#include "ui/text/language.h"
#include "ui/text/shown_units.h"

namespace drillwave {

/// Result that an objective uses, with the unit in which it is shown.
struct AimedOutput {
    const Output* output = nullptr;
    ShownUnit unit;
    double factor = 1;  ///< shown value divided by the value in the study
};

/// Units and number format in which parameters and outputs of a design study are shown.
class DesignUnits {
  public:
    DesignUnits(const DesignStudy& study, const ShownUnits& units,
                std::function<const Unit&(const Parameter&)> fieldUnit, const QLocale& locale)
        : m_study(&study), m_units(units), m_fieldUnit(std::move(fieldUnit)), m_locale(locale) {}

    /// Returns an output with its unit and factor; `size` is its typical magnitude, as in the study.
    AimedOutput of(const Output& output, double size) const;
    /// Returns the unit of a parameter: shown value = SI value · factor.
    ShownUnit of(const Parameter& parameter) const;
    /// Returns the value of a parameter (in SI) with its unit, such as "240 µs" or "0.504".
    QString text(const Parameter& parameter, double si) const;
    /// Returns a value of a design variable with its unit, or as a word.
    QString text(const SweepAxis& choice, double value) const;
    /// Returns the value of an output with its unit.
    QString text(const AimedOutput& output, double value, int digits = 4) const;
    /// Returns the values of all design variables of a design, such as "240 µs, 3.66 m"; "this scenario" if
    /// nothing is varied.
    QString designName(std::uint64_t design) const;
    const QLocale& locale() const { return m_locale; }
    /// Returns the style of sentences with these units and this number format.
    LocalStyle style() const { return {m_locale, m_units.system, m_units.chosen}; }

  private:
    const DesignStudy* m_study;
    ShownUnits m_units;
    std::function<const Unit&(const Parameter&)> m_fieldUnit;
    QLocale m_locale;
};

/// Returns the name of an objective, such as "efficiency in the worst 5 %".
QString aimName(const DesignAim& aim);
/// Returns the name of a design variable for an axis, such as "duration t₀" or "hammer".
QString choiceName(const SweepAxis& choice);
/// Returns an objective in words, such as "largest efficiency in the worst 5 %".
QString aimWords(const DesignAim& aim);

/// Returns the value of an objective for a design with its error and unit.
QString valueText(const DesignReport& report, const DesignAim& aim, std::size_t design,
                  const DesignUnits& units);

/// Names as in the rows, axes and fields of the page. The arguments must outlive the object.
class ShownDesignNames : public DesignNames {
  public:
    ShownDesignNames(const DesignStudy& study, const DesignUnits& units, const ReadingStyle& style)
        : DesignNames(study, style), m_units(units) {}

    std::string design(std::uint64_t design) const override;
    std::string choiceValue(const SweepAxis& choice, double value) const override;
    Message aim(const DesignAim& aim) const override { return aimName(aim).toStdString(); }
    Message choice(const SweepAxis& choice) const override { return choiceName(choice).toStdString(); }
    std::string value(const Output& output, double number, int significant) const override;
    std::string aimed(const DesignReport& report, const DesignAim& aim, std::size_t design) const override;

  private:
    const DesignUnits& m_units;
};

}  // namespace drillwave
