// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/design/design_units.h"

#include "core/report/design_figure.h"
#include "core/report/output_words.h"
#include "ui/job/output_text.h"
#include "ui/pages/design/aim_rows.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

QString withUnit(const QString& number, const QString& unit) {
    return unit.isEmpty() ? number : number + QChar(QChar::Nbsp) + unit;
}

}  // namespace

std::string DesignUnits::choiceValue(const SweepAxis& choice, double value) const {
    if (choice.parameter) return text(*choice.parameter, value).toStdString();
    const std::string word = DesignNames::choiceValue(choice, value);
    return (choice.words ? coreName(word) : coreText(word)).toStdString();
}

Message DesignUnits::choice(const SweepAxis& choice) const {
    return choice.parameter ? DesignNames::choice(choice) : Message(coreName(choice.key()).toStdString());
}

QString DesignUnits::text(const Parameter& parameter, double si) const {
    const ShownUnit unit = shownUnit(m_fieldUnit(parameter));
    return withUnit(numberText(si * unit.factor, 4, m_locale), unit.unit);
}

QString DesignUnits::text(const Output& output, double value, int digits, std::optional<double> error) const {
    const ShownUnit unit = outputUnit(output, m_units, std::abs(value));
    const auto number = [&](double of, int significant) {
        return numberText(designOrdinate(m_study, output, of) * unit.factor, significant, m_locale);
    };
    const QString text = number(value, digits);
    return withUnit(error ? text + QStringLiteral(" ± ") + number(*error, 1) : text, unit.unit);
}

QString DesignUnits::aimedText(const DesignReport& report, const DesignAim& aim, std::size_t design) const {
    const SampledValue& value = aimedValue(report, aim, design);
    return text(*aim.output, value.value, 4,
                aim.statistic.hasError() ? std::optional(value.error()) : std::nullopt);
}

QString DesignUnits::designName(std::uint64_t design) const {
    const std::string name = DesignNames::design(design);
    return m_study.choices.empty() ? drillwave::tr("this scenario") : QString::fromStdString(name);
}

QString aimName(const DesignAim& aim) {
    return translated({"%1 (%2)", {outputMessage(*aim.output), statisticMessage(aim.statistic, aim.sense)}});
}

QString aimWords(const DesignAim& aim) {
    return (aim.sense == Sense::largest ? AimRow::tr("largest %1") : AimRow::tr("least %1"))
        .arg(aimName(aim));
}

}  // namespace drillwave
