// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/study/axis_fields.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>

#include "ui/form/choice_box.h"
#include "ui/form/quantity_field.h"
#include "ui/pages/study/flow_layout.h"
#include "ui/pages/study/parameter_names.h"
#include "ui/text/unit_choice.h"

namespace drillwave {
namespace {

QHBoxLayout* rowOf(QWidget* widget) {
    auto* layout = new QHBoxLayout(widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    return layout;
}

}  // namespace

AxisFields::AxisFields(const QString& words, std::vector<std::string_view> preferred, QWidget* parent)
    : QWidget(parent),
      m_preferred(std::move(preferred)),
      m_words(words),
      m_layout(new FlowLayout(this)),
      m_parameters(new ChoiceBox(this)),
      m_logarithmic(new QCheckBox(tr("log"), this)) {
    // Label and box do not part.
    auto* choice = new QWidget(this);
    auto* choiceLayout = rowOf(choice);
    auto* label = new QLabel(words, choice);
    label->setBuddy(m_parameters);
    choiceLayout->addWidget(label);
    choiceLayout->addWidget(m_parameters);
    m_parameters->setObjectName(QStringLiteral("parameter"));
    m_parameters->setAccessibleName(tr("%1: parameter").arg(words));
    m_logarithmic->setObjectName(QStringLiteral("logarithmic"));
    m_logarithmic->setAccessibleName(tr("%1: logarithmic").arg(words));
    m_logarithmic->setToolTip(tr("Even ratios in place of even steps"));
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(4);
    m_layout->addWidget(choice);
    m_layout->addWidget(m_logarithmic);
    connect(m_parameters, &QComboBox::currentIndexChanged, this, &AxisFields::choose);
    connect(m_logarithmic, &QCheckBox::toggled, this, [this](bool logarithmic) {
        StudyRange range = m_range;
        range.logarithmic = logarithmic;
        setRange(range);
    });
}

void AxisFields::present(const Scenario& scenario) {
    m_scenario = scenario;
    offerParameters(*m_parameters, scenario);
    if (m_range.parameter && m_range.parameter->applies(scenario)) return;
    const auto applies = [&](std::string_view key) { return findParameter(key)->applies(scenario); };
    const auto found = std::ranges::find_if(m_preferred, applies);
    if (found != m_preferred.end()) chooseParameter(*m_parameters, findParameter(*found));
    choose();
}

void AxisFields::choose() {
    if (const Parameter* parameter = chosenParameter(*m_parameters))
        setRange(rangeAround(*parameter, m_scenario));
}

void AxisFields::setRange(const StudyRange& range) {
    if (range == m_range) return;
    const bool other = range.parameter != m_range.parameter;
    m_range = range;
    chooseParameter(*m_parameters, range.parameter);
    if (other) addFields();
    m_start->setValue(range.start);
    m_stop->setValue(range.stop);
    // Ratios need ends above zero.
    m_logarithmic->setEnabled(range.logarithmic || (range.start > 0 && range.stop > 0));
    const QSignalBlocker quiet(m_logarithmic);
    m_logarithmic->setChecked(range.logarithmic);
    emit changed();
}

// A field is of one quantity for its life.
void AxisFields::addFields() {
    for (QuantityField* old : {m_start, m_stop}) {
        if (!old) continue;
        m_layout->removeWidget(old->parentWidget());
        old->parentWidget()->hide();
        old->parentWidget()->deleteLater();
    }
    m_layout->removeWidget(m_logarithmic);
    m_start = addField(tr("from"), QStringLiteral("start"), &StudyRange::start);
    m_stop = addField(tr("to"), QStringLiteral("stop"), &StudyRange::stop);
    m_layout->addWidget(m_logarithmic);
    setTabOrder(m_parameters, m_start);
    setTabOrder(m_start, m_stop);
    setTabOrder(m_stop, m_logarithmic);
    updateGeometry();
}

// In a row with its name and its unit, which stay together.
QuantityField* AxisFields::addField(const QString& words, const QString& name, double StudyRange::*end) {
    const Parameter& parameter = *m_range.parameter;
    auto* row = new QWidget(this);
    auto* layout = rowOf(row);
    UnitChoice& units = UnitChoice::shared();
    auto* field = new QuantityField(parameter.quantity, units.fieldUnit(parameter), row);
    connect(&units, &UnitChoice::changed, field,
            [field, &units, &parameter] { field->setUnit(units.fieldUnit(parameter)); });
    field->setObjectName(name);
    field->setAccessibleName(QStringLiteral("%1: %2 %3").arg(m_words, parameterName(parameter), words));
    field->setTaker([this, end](double si) { return take(end, si); });
    auto* label = new QLabel(words, row);
    label->setBuddy(field);
    layout->addWidget(label);
    layout->addWidget(field);
    if (QToolButton* unit = field->unitButton()) {
        unit->setAccessibleName(tr("%1, unit").arg(field->accessibleName()));
        layout->addWidget(unit);
    }
    m_layout->addWidget(row);
    row->show();
    return field;
}

QString AxisFields::take(double StudyRange::*end, double si) {
    const std::string outside = rangeProblem(*m_range.parameter, si);
    if (!outside.empty()) return QString::fromStdString(outside);
    if (m_range.logarithmic && !(si > 0)) return tr("must be greater than 0 on a logarithmic axis");
    StudyRange range = m_range;
    range.*end = si;
    if (range.start == range.stop) return tr("must differ from the other end");
    setRange(range);
    return {};
}

bool AxisFields::isValid() const {
    return m_range.parameter && m_start->problem().isEmpty() && m_stop->problem().isEmpty();
}

}  // namespace drillwave
