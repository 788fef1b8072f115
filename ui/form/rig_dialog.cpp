// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/rig_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <array>

#include "core/model/validation.h"
#include "ui/form/choice_box.h"
#include "ui/form/quantity_field.h"
#include "ui/text/language.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr std::array askedKeys{"rod.diameter", "rod.bore",    "rod.youngs_modulus",
                               "rod.density",  "pulse.force", "pulse.duration"};

// The choice as a scenario, for the table of parameters.
Scenario scenarioOf(const RigChoice& choice) {
    Scenario scenario;
    scenario.rod = choice.rod;
    scenario.pulse.duration = choice.duration;
    scenario.pulse.impulse = choice.meanForce * choice.duration;
    return scenario;
}

}  // namespace

RigDialog::RigDialog(Document& document, QWidget* parent)
    : QDialog(parent), m_document(document), m_rod(new ChoiceBox(this)), m_result(new QLabel(this)) {
    setWindowTitle(tr("Rig of these groups"));
    setObjectName(QStringLiteral("rigDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_rod->setObjectName(QStringLiteral("rod"));
    m_rod->addItem(tr("custom"));
    for (const PresetSource& source : m_library.sources())
        for (const Preset& preset : source.presets) {
            if (preset.kind != PresetKind::rod) continue;
            m_presets.push_back(&preset);
            m_rod->addItem(coreText(preset.name));
        }
    auto* form = new QFormLayout;
    form->addRow(tr("&Rod"), m_rod);
    for (const char* key : askedKeys) {
        QuantityField* field = addNumber(key);
        auto* row = new QHBoxLayout;
        row->addWidget(field, 1);
        row->addWidget(field->unitButton());
        auto* label = new QLabel(parameterLabel(*findParameter(key)), this);
        label->setBuddy(field);
        form->addRow(label, row);
    }
    m_result->setObjectName(QStringLiteral("result"));
    m_result->setWordWrap(true);
    m_result->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_accept = buttons->addButton(tr("Make the rig"), QDialogButtonBox::AcceptRole);
    m_accept->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &RigDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(m_result);
    layout->addWidget(buttons);
    connect(m_rod, &QComboBox::activated, this, &RigDialog::usePreset);
    connect(&document, &Document::scenarioChanged, this, &QDialog::reject);
    showChoice();
}

QuantityField* RigDialog::addNumber(const char* key) {
    const KeptParameter parameter = findParameter(key);
    auto* field = new QuantityField(parameter, m_document.units(), this);
    field->setObjectName(QLatin1String(key));
    field->setAccessibleName(parameterLabel(*parameter));
    field->setHelp(coreText(parameter->meaning), {});
    field->setTaker([this, parameter](double si) -> QString {
        if (const Message problem = rangeProblem(*parameter, si); !problem.isEmpty())
            return translated(problem);
        if (parameter->key == "pulse.force") {
            m_choice.meanForce = si;
        } else if (parameter->key == "pulse.duration") {
            m_choice.duration = si;
        } else {
            Scenario scenario = scenarioOf(m_choice);
            parameter->assign(scenario, si);
            m_choice.rod = scenario.rod;
            m_rod->setCurrentIndex(0);
        }
        showChoice();
        return {};
    });
    m_fields.append(field);
    return field;
}

void RigDialog::usePreset(int index) {
    if (index > 0)
        m_choice.rod = withPreset(scenarioOf(m_choice), *m_presets[static_cast<std::size_t>(index) - 1]).rod;
    showChoice();
}

// Shows the numbers that follow from the groups, or why there is no such rig.
void RigDialog::showChoice() {
    const Scenario asked = scenarioOf(m_choice);
    for (QuantityField* field : std::as_const(m_fields)) {
        const KeptParameter parameter = findParameter(field->objectName().toStdString());
        if (parameter->key == "pulse.force")
            field->setValue(m_choice.meanForce);
        else
            field->setValue(parameter->value(asked));
    }
    const Scenario rig = rigOf(m_document.scenario(), m_choice);
    const Message problem = invalidity(rig);
    m_accept->setEnabled(problem.isEmpty());
    if (!problem.isEmpty()) return m_result->setText(QStringLiteral("⚠ ") + translated(problem));
    const LocalStyle style = LocalStyle::of(m_document.units());
    const auto text = [&](double si, Quantity quantity) {
        return QString::fromStdString(style.quantity(si, quantity, 4));
    };
    m_result->setText(tr("The groups give a rod of %1, an impulse of %2, a stiffness of %3 and a gap of %4.")
                          .arg(text(rig.rod.length, Quantity::length),
                               text(m_choice.meanForce * m_choice.duration, Quantity::impulse),
                               text(rig.bitRock.stiffness, Quantity::stiffness),
                               text(rig.bitRock.gap, Quantity::length)));
}

void RigDialog::accept() {
    const Scenario rig = rigOf(m_document.scenario(), m_choice);
    disconnect(&m_document, &Document::scenarioChanged, this, nullptr);
    const QString problem = m_document.useScenario(rig, tr("make a rig of the groups"));
    if (problem.isEmpty()) return QDialog::accept();
    connect(&m_document, &Document::scenarioChanged, this, &QDialog::reject);
    m_result->setText(QStringLiteral("⚠ ") + problem);
}

QString waysToPhysicalUnits() {
    return RigDialog::tr(
        "Edit ▸ Make a rig of these groups gives it physical units; File ▸ New begins another one.");
}

}  // namespace drillwave
