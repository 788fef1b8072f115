// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/study/missing_fields.h"

#include <QLabel>

#include "core/model/parameter.h"
#include "ui/form/quantity_field.h"
#include "ui/pages/study/flow_layout.h"
#include "ui/pages/study/parameter_names.h"
#include "ui/text/shown_text.h"

namespace drillwave {

MissingFields::MissingFields(const std::vector<std::string_view>& keys, const UnitChoice& units,
                             QWidget* parent)
    : QWidget(parent) {
    auto* layout = new FlowLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    for (const std::string_view key : keys) {
        const KeptParameter parameter = findParameter(key);
        auto* label = new QLabel(tr("enter the %1:").arg(parameterName(*parameter)), this);
        auto* field = new QuantityField(parameter, units, this);
        field->setObjectName(QStringLiteral("missing.") + fromView(key));
        field->setAccessibleName(parameterName(*parameter));
        field->setToolTip(coreText(parameter->meaning));
        field->setOptional(tr("not given"));
        label->setBuddy(field);
        // A value is taken when it is complete: the first digit of it would already take the field away.
        field->setTaker([parameter](double si) { return translated(rangeProblem(*parameter, si)); });
        connect(field, &QuantityField::editsEnded, this, [this, parameter, field] {
            if (field->value() && field->problem().isEmpty()) emit entered(parameter, *field->value());
        });
        for (QWidget* part : {static_cast<QWidget*>(label), static_cast<QWidget*>(field),
                              static_cast<QWidget*>(field->unitButton())})
            layout->addWidget(part);
        m_fields.push_back({parameter, label, field, field->unitButton()});
    }
    hide();  // until something is missing: a page keeps no room for it
}

void MissingFields::present(const Scenario& scenario) {
    bool any = false;
    for (const Field& each : m_fields) {
        const bool isMissing = each.parameter->applies(scenario) && !each.parameter->value(scenario);
        if (!isMissing) each.field->setValue(std::nullopt);
        for (QWidget* part :
             {static_cast<QWidget*>(each.label), static_cast<QWidget*>(each.field), each.unit})
            part->setVisible(isMissing);
        any |= isMissing;
    }
    setVisible(any);
}

}  // namespace drillwave
