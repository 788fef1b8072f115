// SPDX-License-Identifier: GPL-3.0-or-later
// Units and names in which a design study is shown in the window and in pictures.
#pragma once

#include <QLocale>
#include <QString>
#include <functional>
#include <optional>

#include "core/report/design_words.h"
#include "ui/text/language.h"
#include "ui/text/shown_units.h"

namespace drillwave {

/// Returns the name of an objective, such as "efficiency reached in 95 % of cases".
QString aimName(const DesignAim& aim);

/// Base class that holds the style of numbers and sentences. It is constructed before the names, which refer
/// to it.
struct DesignStyle {
    LocalStyle own;
};

/// Names, numbers and units of a design study as the page Design shows them, in rows, axes and fields.
class DesignUnits : private DesignStyle, public DesignNames {
  public:
    /// Stores a reference to the study, which must outlive the object.
    DesignUnits(const DesignStudy& study, const ShownUnits& units,
                std::function<const Unit&(const Parameter&)> fieldUnit, const QLocale& locale)
        : DesignStyle{{locale, units.system, units.chosen}},
          DesignNames(study, own),
          m_study(study),
          m_units(units),
          m_fieldUnit(std::move(fieldUnit)),
          m_locale(locale) {}

    std::string design(std::uint64_t design) const override { return designName(design).toStdString(); }
    std::string choiceValue(const SweepAxis& choice, double value) const override;
    Message aim(const DesignAim& aim) const override { return aimName(aim).toStdString(); }
    Message choice(const SweepAxis& choice) const override;
    std::string value(const Output& output, double value, int digits) const override {
        return text(output, value, digits).toStdString();
    }
    std::string aimed(const DesignReport& report, const DesignAim& aim, std::size_t design) const override {
        return aimedText(report, aim, design).toStdString();
    }

    /// Returns the value of a parameter (in SI) with its unit, such as "240 µs" or "0.504".
    QString text(const Parameter& parameter, double si) const;
    /// Returns a text with the value of an output, its error and its unit. `value` and `error` are in the
    /// units of the study.
    QString text(const Output& output, double value, int digits = 4, std::optional<double> error = {}) const;
    /// Returns the value of an objective that a design reaches, with its error and unit. `design` is the
    /// index of the design.
    QString aimedText(const DesignReport& report, const DesignAim& aim, std::size_t design) const;
    /// Returns the values of all design variables of a design, such as "240 µs, 3.66 m"; "this scenario" if
    /// nothing is varied.
    QString designName(std::uint64_t design) const;
    const QLocale& locale() const { return m_locale; }

  private:
    const DesignStudy& m_study;
    ShownUnits m_units;
    std::function<const Unit&(const Parameter&)> m_fieldUnit;
    QLocale m_locale;
};

/// Returns an objective in words, such as "largest efficiency reached in 95 % of cases".
QString aimWords(const DesignAim& aim);

}  // namespace drillwave
