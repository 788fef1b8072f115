// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/identify/known_fields.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "core/model/parameter.h"
#include "core/study/identify/identify_study.h"
#include "core/text/units.h"
#include "ui/form/quantity_field.h"
#include "ui/pages/study/flow_layout.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {

namespace {

constexpr double percentPoint = 0.01;

QString toleranceLabel(const AssumedTolerance& tolerance, const Scenario& scenario) {
    if (tolerance.key == "gain") return tr("gain of the amplifier [%]");
    if (tolerance.key == "zero") return tr("zero line [% of the peak]");
    if (tolerance.key == "gauge") return tr("place of the gauge");
    const KeptParameter parameter = findParameter(tolerance.key);
    QString label = parameter ? parameterLabel(*parameter, scenario) : fromView(tolerance.key);
    return label.replace(u'_', u' ');
}

}  // namespace

KnownFields::KnownFields(QWidget* parent) : QWidget(parent), m_layout(new FlowLayout(this)) {}

void KnownFields::present(const Scenario& scenario, const GaugePlace& place) {
    const std::vector<AssumedTolerance> rows = assumedTolerances(scenario, place);
    const bool isSame =
        std::equal(rows.begin(), rows.end(), m_fields.begin(), m_fields.end(),
                   [](const AssumedTolerance& row, const Field& field) { return row.key == field.key; });
    if (!isSame) rebuild(scenario, rows);
}

void KnownFields::rebuild(const Scenario& scenario, const std::vector<AssumedTolerance>& rows) {
    while (QLayoutItem* item = m_layout->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater();
        delete item;
    }
    m_fields.clear();
    for (const AssumedTolerance& row : rows) {
        const QString name = toleranceLabel(row, scenario);
        auto* box = new QWidget(this);
        auto* line = new QHBoxLayout(box);
        line->setContentsMargins(0, 0, 0, 0);
        line->setSpacing(4);
        auto* label = new QLabel(name + QStringLiteral(" ±"), box);
        const bool isRatio = row.quantity == Quantity::ratio;
        const Unit& unit = isRatio ? unitsOf(Quantity::ratio).front()
                                   : *findUnit(row.quantity, row.quantity == Quantity::area ? "mm^2" : "mm");
        auto* field = new QuantityField(row.quantity, unit, box);
        field->setObjectName(QStringLiteral("known.") + fromView(row.key));
        field->setAccessibleName(tr("tolerance of %1").arg(name));
        // Grey, as a proposal.
        field->setOptional(row.tolerance ? numberText(unit.fromSi(*row.tolerance), 2, QLocale())
                                         : tr("assumed"));
        field->setHelp(tr("95 % tolerance; empty: assumed"), field->accessibleName());
        const double factor = isRatio ? percentPoint : 1;
        if (const auto typed = m_typed.find(row.key); typed != m_typed.end())
            field->setValue(typed->second / factor);
        field->setTaker([this, key = row.key, factor](double value) {
            if (!(value > 0)) return tr("must be positive");
            m_typed[key] = value * factor;
            emit changed();
            return QString();
        });
        connect(field, &QuantityField::cleared, this, [this, key = row.key] {
            m_typed.erase(key);
            emit changed();
        });
        label->setBuddy(field);
        line->addWidget(label);
        line->addWidget(field);
        if (QToolButton* button = field->unitButton()) {
            button->setAccessibleName(tr("%1, unit").arg(field->accessibleName()));
            line->addWidget(button);
        }
        m_layout->addWidget(box);
        box->show();
        m_fields.push_back({row.key, field});
    }
}

std::vector<KnownTolerance> KnownFields::known() const {
    std::vector<KnownTolerance> known;
    for (const Field& field : m_fields)
        if (const auto typed = m_typed.find(field.key); typed != m_typed.end())
            known.push_back({field.key, typed->second});
    return known;
}

bool KnownFields::goTo(const std::string& key) {
    for (const Field& field : m_fields) {
        if (field.key != key) continue;
        field.field->setFocus(Qt::OtherFocusReason);
        field.field->selectAll();
        return true;
    }
    return false;
}

}  // namespace drillwave
