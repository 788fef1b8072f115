// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/study/option_fields.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

#include "core/model/parameter.h"
#include "ui/form/choice_box.h"
#include "ui/form/quantity_field.h"
#include "ui/pages/study/axis_fields.h"
#include "ui/pages/study/labelled_control.h"
#include "ui/text/shown_text.h"

namespace drillwave {

OptionFields::OptionFields(const Study& study, const UnitChoice& units, QWidget* page)
    : QObject(page), m_study(study), m_units(units) {
    for (const StudyOption& option : study.options) {
        if (option.group && !m_groups.contains(option.group))
            m_groups[option.group] = groupBox(*option.group, page);
        if (const auto* quantity = std::get_if<QuantityControl>(&option.control)) {
            auto* box = new QWidget(page);
            auto* row = new QHBoxLayout(box);
            row->setContentsMargins(0, 0, 0, 0);
            row->setSpacing(4);
            box->hide();
            m_quantities.push_back({&option, quantity, box});
            m_widgets << box;
        } else if (const auto* range = std::get_if<RangeControl>(&option.control)) {
            auto* fields = new AxisFields(translated(option.label), range->preferred, units, page);
            connect(fields, &AxisFields::changed, this, &OptionFields::changed);
            m_ranges.emplace_back(&option, fields);
            m_widgets << fields;
        }
    }
}

ChoiceBox* OptionFields::groupBox(const StudyGroup& group, QWidget* page) {
    auto* choice = new ChoiceBox(page);
    choice->setObjectName(fromView(group.key));
    choice->setAccessibleName(translated(group.name));
    choice->setToolTip(translated(group.tip));
    choice->addItem(translated(group.without));
    choice->addItem(translated(group.with));
    connect(choice, &QComboBox::currentIndexChanged, this, [this] {
        showFields();
        emit changed();
    });
    m_widgets << labelled(translated(group.label), choice, page);
    return choice;
}

bool OptionFields::isGiven(const StudyOption& option) const {
    return !option.group || m_groups.at(option.group)->currentIndex() == 1;
}

Quantity OptionFields::quantityOf(const QuantityControl& control) const {
    return hasUnits(m_scenario) ? findParameter(control.like)->quantity : Quantity::ratio;
}

const Unit& OptionFields::unitOf(const QuantityControl& control) const {
    return hasUnits(m_scenario) ? findParameter(control.like)->displayUnit()
                                : unitsOf(Quantity::ratio).front();
}

void OptionFields::present(const Scenario& scenario) {
    const bool hasOtherForm = m_scenario.form != scenario.form;
    m_scenario = scenario;
    for (const auto& [option, fields] : m_ranges) {
        const QSignalBlocker quiet(fields);  // what it chooses now is asked for right here
        fields->present(scenario);
    }
    if (!hasOtherForm) return;
    for (Quantified& quantified : m_quantities) quantified.value = 0;
    showFields();
}

// A field is of one quantity for its life.
void OptionFields::showFields() {
    QWidget* before = nullptr;
    for (Quantified& quantified : m_quantities) {
        for (QWidget* child : quantified.box->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
            child->setObjectName({});
            child->hide();
            child->deleteLater();
        }
        quantified.field = nullptr;
        const bool isShown = isGiven(*quantified.option);
        quantified.box->setVisible(isShown);
        if (!isShown) continue;
        addField(quantified);
        if (before) QWidget::setTabOrder(before, quantified.field);
        before = quantified.field;
    }
}

void OptionFields::addField(Quantified& quantified) {
    const StudyOption& option = *quantified.option;
    const QuantityControl& control = *quantified.control;
    QWidget* box = quantified.box;
    auto* field = hasUnits(m_scenario) ? new QuantityField(*findParameter(control.like), m_units, box)
                                       : new QuantityField(Quantity::ratio, unitOf(control), box);
    quantified.field = field;
    field->setObjectName(fromView(option.key));
    field->setAccessibleName(translated(option.name));
    field->setStepAtZero(control.step(m_scenario));
    // A value that is read at a glance.
    if (quantified.value == 0) quantified.value = field->rounded(control.proposed(m_scenario));
    field->setValue(quantified.value);
    field->setTaker([this, &quantified](double value) { return take(quantified, value); });
    auto* label = new QLabel(translated(option.label), box);
    label->setBuddy(field);
    QList<QWidget*> row{label, field};
    if (QToolButton* unit = field->unitButton()) {
        unit->setAccessibleName(tr("%1, unit").arg(field->accessibleName()));
        row << unit;
    }
    for (QWidget* each : row) {
        box->layout()->addWidget(each);
        each->show();
    }
}

QString OptionFields::take(Quantified& quantified, double value) {
    const double before = std::exchange(quantified.value, value);
    const std::optional<StudyProblem> problem = m_study.problem({m_scenario, words()});
    if (problem && problem->option == quantified.option->key) {
        quantified.value = before;
        return QStringLiteral("%1: %2").arg(translated(quantified.option->name), translated(problem->reason));
    }
    emit changed();
    return {};
}

StudyWords OptionFields::words() const {
    StudyWords words;
    for (const Quantified& quantified : m_quantities)
        if (isGiven(*quantified.option))
            words.emplace(quantified.option->key,
                          formatQuantity(quantified.value, quantityOf(*quantified.control),
                                         unitOf(*quantified.control)));
    for (const auto& [option, fields] : m_ranges)
        if (fields->range().parameter)
            words.emplace(option->key, fields->range().text() + fields->range().tail());
    return words;
}

}  // namespace drillwave
