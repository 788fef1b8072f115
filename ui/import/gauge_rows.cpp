// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/gauge_rows.h"

#include <numbers>

#include "ui/import/import_rows.h"

namespace drillwave {
namespace {

enum Bar { ofScenario, otherBar };

}  // namespace

GaugeRows::GaugeRows(QFormLayout& form, const std::function<void()>& changed) : m_form(form) {
    m_bar = addChoice(form, {"bar", tr("gauge is on"), tr("Whose E and area make a force of a strain")},
                      {{tr("the rod or string"), ofScenario}, {tr("another bar"), otherBar}});
    m_modulus = addQuantity(form, {"modulus", tr("E of the bar"), tr("Young's modulus")}, Quantity::stress,
                            "GPa", FieldRange::positive, 210e9, changed);
    m_diameter = addQuantity(form, {"diameter", tr("diameter"), tr("Of the solid bar where the gauge is")},
                             Quantity::length, "mm", FieldRange::positive, 0.02, changed);
    m_gaugeFactor =
        addQuantity(form, {"gaugeFactor", tr("gauge factor k"), tr("Relative resistance over strain")},
                    Quantity::ratio, "", FieldRange::positive, 2, changed);
    m_activeGauges =
        addChoice(form,
                  {"activeGauges", tr("active gauges"),
                   tr("Of the bridge that see the strain: 1 quarter, 2 half, 4 full bridge")},
                  {{QStringLiteral("1"), 1}, {QStringLiteral("2"), 2}, {QStringLiteral("4"), 4}});
    m_fields = {m_modulus, m_diameter, m_gaugeFactor};
    for (ChoiceBox* box : {m_bar, m_activeGauges})
        QObject::connect(box, &QComboBox::currentIndexChanged, box, changed);
}

void GaugeRows::offerScenario(bool offered) {
    m_isOffered = offered;
    if (!offered) choose(*m_bar, otherBar);
}

bool GaugeRows::isOnScenario() const {
    return m_isOffered && chosenValue(*m_bar) == ofScenario;
}

void GaugeRows::show(SignalKind kind) {
    const bool needsBar = kind != SignalKind::force;
    const bool typed = needsBar && !isOnScenario();
    setRowVisible(m_form, *m_bar, needsBar && m_isOffered);
    setRowVisible(m_form, *m_modulus, typed);
    setRowVisible(m_form, *m_diameter, typed);
    setRowVisible(m_form, *m_gaugeFactor, kind == SignalKind::bridge);
    setRowVisible(m_form, *m_activeGauges, kind == SignalKind::bridge);
}

GaugedBar GaugeRows::bar(double stiffness) const {
    const double diameter = *m_diameter->value();
    const double typed = *m_modulus->value() * std::numbers::pi / 4 * diameter * diameter;
    return {isOnScenario() ? stiffness : typed, *m_gaugeFactor->value(),
            static_cast<double>(chosenValue(*m_activeGauges))};
}

}  // namespace drillwave
