// SPDX-License-Identifier: GPL-3.0-or-later
// Picture of a study of designs.
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

/// An output of an aim in the unit it is shown in.
struct AimedOutput {
    const Output* output = nullptr;
    ShownUnit unit;
    double factor = 1;  ///< what is shown over what the study has
};

/// Curves over the last choice, one set for each combination of the others.
struct DesignSeries {
    QString name;  ///< the other choices; empty where there are none
    QVector<QPointF> aim, low, high, mean, nominal;
    QVector<std::uint64_t> designs;  ///< of each point
};

struct SobolBar {
    QString name;
    double first = 0, total = 0;
};

/// All in shown units; never changed once built.
struct DesignPicture {
    QString xName;  ///< of the last choice; empty where nothing is chosen
    ShownUnit x;
    bool isLogarithmic = false;
    QVector<QString> words;  ///< of a choice of words, which has their numbers from 0 as x; of no choice one
    AimedOutput value;       ///< of the first aim
    QString aimName;         ///< "efficiency in the worst 5 %"
    QString statisticName;   ///< "in the worst 5 %"
    QVector<DesignSeries> series;
    int marked = 0;                          ///< the series of the robust best, which has the band
    std::optional<MapPicture> map;           ///< instead of series, which are empty then
    std::optional<QPointF> robust, nominal;  ///< best; beside series the nominal one at its nominal value
    QVector<QPointF> ties;
    QString robustName, nominalName, presentName;  ///< "240 µs"; the last empty where it is no design

    QString firstAim, secondAim;  ///< names of the axes; the second empty for a single objective
    QVector<QPointF> designs;     ///< second over first aim, design by design; NaN without statistics
    QVector<bool> pareto;
    int robustNumber = -1;

    struct Bars {
        QString output;
        QVector<SobolBar> bars;  ///< empty where it does not scatter, or one number alone is uncertain
    };
    QVector<Bars> bars;
    QString summary;
};

/// Units of the parameters and outputs of an answer.
class DesignUnits {
  public:
    DesignUnits(const DesignStudy& study, const ShownUnits& units,
                std::function<const Unit&(const Parameter&)> fieldUnit, const QLocale& locale)
        : m_study(&study), m_units(units), m_fieldUnit(std::move(fieldUnit)), m_locale(locale) {}

    AimedOutput of(const Output& output, double size) const;
    ShownUnit of(const Parameter& parameter) const;
    /// "240 µs", "0.504".
    QString text(const Parameter& parameter, double si) const;
    QString text(const SweepAxis& choice, double value) const;
    QString text(const AimedOutput& output, double value, int digits = 4) const;
    /// "240 µs", "240 µs, 3.66 m"; of no choice "this scenario".
    QString designName(std::uint64_t design) const;
    const QLocale& locale() const { return m_locale; }
    /// The style of sentences in these units.
    LocalStyle style() const { return {m_locale, m_units.system, m_units.chosen}; }

  private:
    const DesignStudy* m_study;
    ShownUnits m_units;
    std::function<const Unit&(const Parameter&)> m_fieldUnit;
    QLocale m_locale;
};

/// "efficiency in the worst 5 %".
QString aimName(const DesignAim& aim);
/// "duration t₀", "hammer": what is chosen, as an axis calls it.
QString choiceName(const SweepAxis& choice);
/// Describes an aim with its sense: "largest efficiency in the worst 5 %".
QString aimWords(const DesignAim& aim);

/// Requires a study that has a best design.
DesignPicture designPicture(const DesignReport& report, const DesignUnits& units);

}  // namespace drillwave
