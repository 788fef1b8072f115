// SPDX-License-Identifier: GPL-3.0-or-later
// Data of the plots of a design study.
#pragma once

#include <QLocale>
#include <QPointF>
#include <QString>
#include <QVector>
#include <functional>
#include <optional>

#include "core/report/design_report.h"
#include "ui/pages/map/map_picture.h"
#include "ui/text/language.h"
#include "ui/text/shown_units.h"

namespace drillwave {

/// Result that an objective uses, with the unit in which it is shown.
struct AimedOutput {
    const Output* output = nullptr;
    ShownUnit unit;
    double factor = 1;  ///< shown value divided by the value in the study
};

/// Curves over the last design variable, for one combination of the values of the other design variables.
struct DesignSeries {
    QString name;  ///< values of the other design variables; empty if there are none
    /// Points of the curves: the objective's statistic, 5 % and 95 % quantile, mean, and value for the inputs
    /// as entered.
    QVector<QPointF> aim, low, high, mean, nominal;
    QVector<std::uint64_t> designs;  ///< index of the design of each point
};

/// Sobol indices of one uncertain input, from 0 to 1: share of the scatter from this input only, and with
/// interactions.
struct SobolBar {
    QString name;
    double first = 0, total = 0;
};

/// Data of all plots of a design study, in the units shown; never changed once built.
struct DesignPicture {
    QString xName;  ///< name of the last design variable; empty if nothing is varied
    ShownUnit x;
    bool isLogarithmic = false;
    /// Names of the values of the last design variable, if these are words: x then is their index from 0. A
    /// single name if nothing is varied.
    QVector<QString> words;
    AimedOutput value;      ///< output of the first objective
    QString aimName;        ///< name of the first objective, such as "efficiency in the worst 5 %"
    QString statisticName;  ///< statistic of the first objective, such as "in the worst 5 %"
    QVector<DesignSeries> series;
    /// Index of the series with the best design for uncertain inputs, for which the band is drawn.
    int marked = 0;
    std::optional<MapPicture> map;  ///< map, shown instead of series; `series` then is empty
    /// Places of the best design for uncertain inputs (robust) and for the values entered (nominal). In plots
    /// of curves the latter is at its value for the inputs as entered.
    std::optional<QPointF> robust, nominal;
    /// Places of the designs that are equally good as the best one.
    QVector<QPointF> ties;
    /// Names of the best designs and of the present design, such as "240 µs". The last is empty if the
    /// present values are not among the designs.
    QString robustName, nominalName, presentName;

    /// Axis labels of the second plot; the second is empty for a single objective.
    QString firstAim, secondAim;
    QVector<QPointF> designs;  ///< second over first objective of each design; NaN without statistics
    /// Whether each design belongs to the Pareto set.
    QVector<bool> pareto;
    /// Index of the best design for uncertain inputs; −1 without a second objective.
    int robustNumber = -1;

    struct Bars {
        QString output;
        QVector<SobolBar> bars;  ///< empty if the output does not scatter or only one input is uncertain
    };
    QVector<Bars> bars;
    QString summary;
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

/// Returns the data of the plots of a report. Requires a report with a best design.
DesignPicture designPicture(const DesignReport& report, const DesignUnits& units);

}  // namespace drillwave
