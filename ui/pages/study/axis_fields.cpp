// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/study/axis_fields.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>

#include "ui/form/choice_box.h"
#include "ui/form/quantity_field.h"
#include "ui/pages/study/flow_layout.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

QHBoxLayout* rowIn(QWidget& part) {
    auto* row = new QHBoxLayout(&part);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    return row;
}

}  // namespace

AxisFields::AxisFields(const QString& words, std::vector<std::string_view> preferred, const UnitChoice& units,
                       QWidget* parent, StudyOf of)
    : QWidget(parent),
      m_preferred(std::move(preferred)),
      m_of(of),
      m_words(words),
      m_units(units),
      m_parameters(new ChoiceBox(this)),
      m_startPart(new QWidget(this)),
      m_stopPart(new QWidget(this)),
      m_logarithmic(new QCheckBox(tr("log"), this)) {
    auto* label = new QLabel(words, this);
    label->setBuddy(m_parameters);
    m_parameters->setObjectName(QStringLiteral("parameter"));
    m_parameters->setAccessibleName(tr("%1: parameter").arg(words));
    m_logarithmic->setObjectName(QStringLiteral("logarithmic"));
    m_logarithmic->setAccessibleName(tr("%1: logarithmic").arg(words));
    m_logarithmic->setToolTip(tr("Even ratios instead of even steps"));
    auto* choice = new QWidget(this);
    for (QWidget* part : {choice, m_startPart, m_stopPart}) rowIn(*part);
    choice->layout()->addWidget(label);
    choice->layout()->addWidget(m_parameters);
    auto* layout = new FlowLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    for (QWidget* part : {choice, m_startPart, m_stopPart, static_cast<QWidget*>(m_logarithmic)})
        layout->addWidget(part);
    connect(m_parameters, &QComboBox::currentIndexChanged, this, &AxisFields::choose);
    connect(m_logarithmic, &QCheckBox::toggled, this, [this](bool logarithmic) {
        StudyRange range = m_range;
        range.logarithmic = logarithmic;
        setRange(range);
    });
}

void AxisFields::present(const Scenario& scenario) {
    m_scenario = scenario;
    offerParameters(*m_parameters, scenario, m_of);
    if (m_range.parameter && m_range.parameter->applies(scenario)) {
        chooseParameter(*m_parameters, m_range.parameter);
        return widen();
    }
    const auto applies = [&](std::string_view key) { return findParameter(key)->applies(scenario); };
    const auto found = std::ranges::find_if(m_preferred, applies);
    if (found != m_preferred.end()) chooseParameter(*m_parameters, findParameter(*found));
    choose();
}

// Parameters of sections have long names: the box is as wide as what is chosen, its list as the longest.
void AxisFields::widen() {
    constexpr int roomForArrow = 40;
    m_parameters->setMinimumWidth(fontMetrics().horizontalAdvance(m_parameters->currentText()) +
                                  roomForArrow);
    QAbstractItemView* list = m_parameters->view();
    list->setMinimumWidth(list->sizeHintForColumn(0) + roomForArrow);
}

void AxisFields::choose() {
    if (const KeptParameter parameter = chosenParameter(*m_parameters))
        setRange(m_of == StudyOf::manyBlows ? rangeOfManyBlows(*parameter, m_scenario)
                                            : rangeAround(*parameter, m_scenario));
}

void AxisFields::setRange(const StudyRange& range) {
    if (range == m_range) return;
    const bool other = range.parameter != m_range.parameter;
    m_range = range;
    chooseParameter(*m_parameters, range.parameter);
    widen();
    if (other) addFields();
    m_start->setValue(range.start);
    m_stop->setValue(range.stop);
    // Ratios need ends above zero.
    const bool mayBeLogarithmic = range.start > 0 && range.stop > 0 && !range.parameter->rules.wholeNumber;
    m_logarithmic->setEnabled(range.logarithmic || mayBeLogarithmic);
    const QSignalBlocker quiet(m_logarithmic);
    m_logarithmic->setChecked(range.logarithmic);
    emit changed();
}

// A field is of one quantity for its life.
void AxisFields::addFields() {
    m_start = addField(*m_startPart, tr("from"), QStringLiteral("start"), &StudyRange::start);
    m_stop = addField(*m_stopPart, tr("to"), QStringLiteral("stop"), &StudyRange::stop);
    setTabOrder(m_parameters, m_start);
    setTabOrder(m_start, m_stop);
    setTabOrder(m_stop, m_logarithmic);
}

// Replaces the present one.
QuantityField* AxisFields::addField(QWidget& part, const QString& words, const QString& name,
                                    double StudyRange::*end) {
    if (QLayoutItem* before = part.layout()->takeAt(0)) {
        before->widget()->hide();
        before->widget()->deleteLater();
        delete before;
    }
    const KeptParameter parameter = m_range.parameter;
    auto* row = new QWidget(&part);
    QHBoxLayout* layout = rowIn(*row);
    auto* field = new QuantityField(parameter, m_units, row);
    field->setObjectName(name);
    field->setAccessibleName(QStringLiteral("%1: %2 %3").arg(m_words, parameterName(*parameter), words));
    field->setTaker([this, end](double si) { return take(end, si); });
    auto* label = new QLabel(words, row);
    label->setBuddy(field);
    layout->addWidget(label);
    layout->addWidget(field);
    if (QToolButton* unit = field->unitButton()) {
        unit->setAccessibleName(tr("%1, unit").arg(field->accessibleName()));
        layout->addWidget(unit);
    }
    part.layout()->addWidget(row);
    row->show();
    return field;
}

QString AxisFields::take(double StudyRange::*end, double si) {
    const Message outside = rangeProblem(*m_range.parameter, si);
    if (!outside.isEmpty()) return translated(outside);
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
