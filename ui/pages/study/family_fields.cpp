// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/study/family_fields.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <algorithm>

#include "ui/form/choice_box.h"
#include "ui/pages/study/parameter_names.h"
#include "ui/text/shown_text.h"
#include "ui/text/typed_text.h"
#include "ui/text/unit_choice.h"

namespace drillwave {
namespace {

// Values apart by ";", and by "," too where that is no decimal sign.
QStringList items(const QString& text, const QLocale& locale) {
    QString separated = text;
    if (locale.decimalPoint() != QLatin1String(",") && !text.contains(QLatin1Char(';')))
        separated.replace(QLatin1Char(','), QLatin1Char(';'));
    return separated.split(QLatin1Char(';'), Qt::SkipEmptyParts);
}

}  // namespace

FamilyFields::FamilyFields(const QString& words, std::vector<StudyFamily> preferred, const UnitChoice& units,
                           QWidget* parent)
    : QWidget(parent),
      m_preferred(std::move(preferred)),
      m_units(units),
      m_parameters(new ChoiceBox(this)),
      m_values(new QLineEdit(this)) {
    auto* label = new QLabel(words, this);
    label->setBuddy(m_parameters);
    m_parameters->setObjectName(QStringLiteral("familyParameter"));
    m_parameters->setAccessibleName(tr("%1: parameter").arg(words));
    m_parameters->addItem(tr("none"), QString());
    m_values->setObjectName(QStringLiteral("familyValues"));
    m_values->setAccessibleName(tr("%1: values").arg(words));
    m_values->setToolTip(tr("One curve for each value, with or without units: 0.1; 0.3; 1"));
    m_values->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("0.01; 0.1; 0.3; 1 MN")));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(label);
    layout->addWidget(m_parameters);
    layout->addWidget(m_values);
    connect(&units, &UnitChoice::changed, this, [this] {
        if (m_problem.isEmpty()) showValues();
    });
    connect(m_parameters, &QComboBox::currentIndexChanged, this, &FamilyFields::choose);
    connect(m_values, &QLineEdit::textEdited, this, &FamilyFields::read);
}

void FamilyFields::present(const Scenario& scenario) {
    m_scenario = scenario;
    offerParameters(*m_parameters, scenario);
    if (m_chosen && (!m_family.parameter || m_family.parameter->applies(scenario))) return;
    const auto found = std::ranges::find_if(
        m_preferred, [&](const StudyFamily& family) { return family.parameter->applies(scenario); });
    setFamily(found != m_preferred.end() ? *found : StudyFamily());
}

void FamilyFields::setFamily(const StudyFamily& family) {
    m_chosen = true;
    chooseParameter(*m_parameters, family.parameter);
    m_values->setEnabled(bool(family.parameter));
    if (family == m_family) return;
    m_family = family;
    showValues();
    emit changed();
}

// Around the present value, until others are typed.
void FamilyFields::choose() {
    const KeptParameter parameter = chosenParameter(*m_parameters);
    if (!parameter) return setFamily({});
    const auto known = std::ranges::find(m_preferred, parameter, &StudyFamily::parameter);
    if (known != m_preferred.end()) return setFamily(*known);
    const StudyRange range = rangeAround(*parameter, m_scenario);
    setFamily({parameter, {range.start, parameter->value(m_scenario).value_or(range.stop / 2), range.stop}});
}

void FamilyFields::showValues() {
    QStringList texts;
    if (m_family.parameter)
        for (const double si : m_family.values)
            texts << localText(QString::fromStdString(formatQuantity(si, m_family.parameter->quantity,
                                                                     m_units.fieldUnit(*m_family.parameter))),
                               locale());
    m_values->setText(texts.join(QStringLiteral("; ")));
    m_problem.clear();
}

void FamilyFields::read() {
    StudyFamily family{m_family.parameter, {}};
    m_problem.clear();
    for (const QString& item : items(m_values->text(), locale())) {
        const PlainText plain = plainText(item.trimmed(), locale());
        const Parameter& parameter = *family.parameter;
        const TypedQuantity typed = parseQuantity(plain.text.toStdString(), parameter.quantity,
                                                  BareNumber::inDefaultUnit, &m_units.fieldUnit(parameter));
        if (!plain.problem.isEmpty())
            m_problem = plain.problem;
        else if (!typed.valid())
            m_problem = translated(typed.problem);
        else
            m_problem = translated(rangeProblem(parameter, typed.si));
        if (!m_problem.isEmpty()) m_problem = QStringLiteral("%1: %2").arg(item.trimmed(), m_problem);
        if (!m_problem.isEmpty()) break;
        if (std::ranges::find(family.values, typed.si) == family.values.end())
            family.values.push_back(typed.si);
    }
    if (m_problem.isEmpty() && family.values.empty()) m_problem = tr("no value");
    if (family.values.size() > mostValues) m_problem = tr("at most %1 values").arg(mostValues);
    m_values->setToolTip(m_problem.isEmpty()
                             ? tr("One curve for each value, with or without units: 0.1; 0.3; 1")
                             : QStringLiteral("⚠ ") + m_problem);
    m_values->setStyleSheet(m_problem.isEmpty() ? QString()
                                                : QStringLiteral("QLineEdit { border: 2px solid #c62828; }"));
    if (!m_problem.isEmpty() || family == m_family) return;
    m_family = family;
    emit changed();
}

}  // namespace drillwave
