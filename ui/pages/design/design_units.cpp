// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/design/design_units.h"

#include <cmath>

#include "core/model/scales.h"
#include "ui/job/output_text.h"
#include "ui/pages/design/aim_rows.h"
#include "ui/pages/study/output_box.h"
#include "ui/pages/study/parameter_names.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {

AimedOutput DesignUnits::of(const Output& output, double size) const {
    AimedOutput shown{&output, outputUnit(output, m_units, size), 1};
    const bool isScaled = hasUnits(m_study->base) && !output.isOnlySi();
    shown.factor = shown.unit.factor / (isScaled ? output.scale(scalesOf(m_study->base)) : 1);
    return shown;
}

ShownUnit DesignUnits::of(const Parameter& parameter) const {
    return shownUnit(m_fieldUnit(parameter));
}

QString DesignUnits::text(const Parameter& parameter, double si) const {
    const ShownUnit unit = of(parameter);
    QString text = numberText(si * unit.factor, 4, m_locale);
    if (!unit.unit.isEmpty()) text += QChar(QChar::Nbsp) + unit.unit;
    return text;
}

QString DesignUnits::text(const SweepAxis& choice, double value) const {
    if (choice.parameter) return text(*choice.parameter, value);
    std::string word;
    choice.column().appendText(word, value);
    return choice.words ? coreName(word) : coreText(word);
}

QString DesignUnits::text(const AimedOutput& output, double value, int digits) const {
    QString text = numberText(value * output.factor, digits, m_locale);
    if (!output.unit.unit.isEmpty()) text += QChar(QChar::Nbsp) + output.unit.unit;
    return text;
}

QString DesignUnits::designName(std::uint64_t design) const {
    QStringList names;
    const std::vector<double> values = m_study->choice(design);
    for (std::size_t i = 0; i < values.size(); ++i) names << text(m_study->choices[i], values[i]);
    return names.isEmpty() ? drillwave::tr("this scenario") : names.join(QStringLiteral(", "));
}

QString aimName(const DesignAim& aim) {
    return outputName(*aim.output) + QLatin1Char(' ') +
           translated(statisticMessage(aim.statistic, aim.sense));
}

QString choiceName(const SweepAxis& choice) {
    return choice.parameter ? parameterName(*choice.parameter) : coreName(choice.key());
}

QString aimWords(const DesignAim& aim) {
    return (aim.sense == Sense::largest ? AimRow::tr("largest %1") : AimRow::tr("least %1"))
        .arg(aimName(aim));
}

QString valueText(const DesignReport& report, const DesignAim& aim, std::size_t design,
                  const DesignUnits& units) {
    const SampledValue& value = aimedValue(report, aim, design);
    const AimedOutput shown = units.of(*aim.output, std::abs(value.value));
    QString text = numberText(value.value * shown.factor, 4, units.locale());
    if (aim.statistic.hasError())
        text += QStringLiteral(" ± ") + numberText(value.error() * shown.factor, 1, units.locale());
    if (!shown.unit.unit.isEmpty()) text += QChar(QChar::Nbsp) + shown.unit.unit;
    return text;
}

std::string ShownDesignNames::design(std::uint64_t design) const {
    return m_units.designName(design).toStdString();
}

std::string ShownDesignNames::choiceValue(const SweepAxis& choice, double value) const {
    return m_units.text(choice, value).toStdString();
}

std::string ShownDesignNames::value(const Output& output, double number, int significant) const {
    return m_units.text(m_units.of(output, std::abs(number)), number, significant).toStdString();
}

std::string ShownDesignNames::aimed(const DesignReport& report, const DesignAim& aim,
                                    std::size_t design) const {
    return valueText(report, aim, design, m_units).toStdString();
}

}  // namespace drillwave
