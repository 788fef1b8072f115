// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/gap/scatter_fields.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "core/model/parameter.h"
#include "core/model/scales.h"
#include "ui/form/choice_box.h"
#include "ui/form/quantity_field.h"
#include "ui/pages/gap/gap_study.h"

namespace drillwave {
namespace {

constexpr double firstDeviation = 0.1;  // d0

Quantity quantityOf(const Scenario& scenario) {
    return scenario.form == ScenarioForm::dimensional ? Quantity::length : Quantity::ratio;
}

const Unit& unitOf(Quantity quantity) {
    return quantity == Quantity::length ? *findUnit(quantity, "mm") : unitsOf(quantity).front();
}

void layOut(QWidget& row) {
    auto* layout = new QHBoxLayout(&row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
}

QWidget* newBox(QWidget* parent) {
    auto* box = new QWidget(parent);
    layOut(*box);
    box->hide();
    return box;
}

}  // namespace

ScatterFields::ScatterFields(const UnitChoice& units, QWidget* parent)
    : QWidget(parent),
      m_units(units),
      m_choice(new ChoiceBox(this)),
      m_meanBox(newBox(parent)),
      m_deviationBox(newBox(parent)) {
    auto* label = new QLabel(tr("gap"), this);
    label->setBuddy(m_choice);
    m_choice->setObjectName(QStringLiteral("scatter"));
    m_choice->setAccessibleName(tr("How the gap scatters"));
    m_choice->setToolTip(
        tr("Nobody controls the gap at the rig: all gaps of a period alike, or a normal "
           "distribution cut off at no gap"));
    m_choice->addItem(tr("all equally likely"));
    m_choice->addItem(tr("mean ± deviation"));
    layOut(*this);
    layout()->addWidget(label);
    layout()->addWidget(m_choice);
    connect(m_choice, &QComboBox::currentIndexChanged, this, &ScatterFields::choose);
}

bool ScatterFields::isScattered() const {
    return m_choice->currentIndex() == 1;
}

void ScatterFields::present(const Scenario& scenario) {
    const bool other = scenario.form != m_scenario.form;
    m_scenario = scenario;
    m_d0 = isDimensional() ? scalesOf(scenario).penetration : 1;
    if (!other) return;
    m_mean = m_deviation = 0;
    if (isScattered()) choose();
}

// At first about the gap there is.
void ScatterFields::choose() {
    if (m_deviation == 0) {
        m_mean = isDimensional() ? m_scenario.bitRock.gap : m_scenario.groups.delta;
        m_deviation = firstDeviation * m_d0;
    }
    addFields();
    emit changed();
}

// A field is of one quantity for its life.
void ScatterFields::addFields() {
    for (QWidget* box : fields()) {
        for (QWidget* child : box->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
            child->setObjectName({});
            child->hide();
            child->deleteLater();
        }
        box->setVisible(isScattered());
    }
    if (!isScattered()) return;
    QuantityField* mean = addField(m_meanBox, tr("mean"), "mean", &ScatterFields::m_mean);
    QuantityField* deviation =
        addField(m_deviationBox, QStringLiteral("±"), "deviation", &ScatterFields::m_deviation);
    deviation->setAccessibleName(tr("standard deviation of the gap"));
    // A length that is read at a glance.
    m_deviation = deviation->rounded(m_deviation);
    deviation->setValue(m_deviation);
    setTabOrder(m_choice, mean);
    setTabOrder(mean, deviation);
}

QuantityField* ScatterFields::addField(QWidget* box, const QString& words, const char* name,
                                       double ScatterFields::*value) {
    const Quantity quantity = quantityOf(m_scenario);
    auto* field = isDimensional() ? new QuantityField(*findParameter("bit_rock.gap"), m_units, box)
                                  : new QuantityField(quantity, unitOf(quantity), box);
    field->setObjectName(QString::fromLatin1(name));
    field->setAccessibleName(tr("%1 of the gap").arg(words));
    field->setStepAtZero(0.01 * m_d0);
    field->setValue(this->*value);
    field->setTaker([this, value](double si) { return take(value, si); });
    auto* label = new QLabel(words, box);
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
    return field;
}

QString ScatterFields::take(double ScatterFields::*value, double si) {
    const double before = this->*value;
    this->*value = si;
    if (QString reason = problem(); !reason.isEmpty()) {
        this->*value = before;
        return reason;
    }
    emit changed();
    return {};
}

QString ScatterFields::problem() const {
    const std::optional<NormalGap> chosen = normal();
    return chosen ? scatterProblem(*chosen) : QString();
}

std::optional<NormalGap> ScatterFields::normal() const {
    if (!isScattered()) return std::nullopt;
    return NormalGap{.mean = m_mean / m_d0, .deviation = m_deviation / m_d0};
}

QStringList ScatterFields::commandWords() const {
    if (!isScattered()) return {};
    const Quantity quantity = quantityOf(m_scenario);
    const auto text = [&](double value) {
        return QString::fromStdString(formatQuantity(value, quantity, unitOf(quantity)));
    };
    return {QStringLiteral("--gap-mean"), text(m_mean), QStringLiteral("--gap-deviation"), text(m_deviation)};
}

}  // namespace drillwave
