// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/import_rows.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <cmath>
#include <numbers>

#include "ui/text/shown_text.h"
#include "ui/text/unfocused_wheel.h"

namespace drillwave {

namespace {

void nameControl(QWidget& control, const RowWords& words) {
    control.setObjectName(QLatin1String(words.name));
    control.setToolTip(words.toolTip);
    control.setAccessibleName(words.label);
}

QString objection(FieldRange range, double si) {
    if (range == FieldRange::notNegative && si < 0) return tr("must not be negative");
    if (range == FieldRange::positive && !(si > 0)) return tr("must be greater than 0");
    if (range == FieldRange::notZero && si == 0) return tr("must not be 0");
    return {};
}

enum Bar { ofScenario, otherBar };

}  // namespace

ChoiceBox* addChoice(QFormLayout& form, const RowWords& words, const QList<RowChoice>& entries) {
    auto* box = new ChoiceBox(form.parentWidget());
    nameControl(*box, words);
    for (const RowChoice& entry : entries) box->addItem(entry.text, entry.value);
    form.addRow(words.label, box);
    return box;
}

void setEntries(ChoiceBox& box, const QList<RowChoice>& entries) {
    const QSignalBlocker quiet(box);
    const int before = chosenValue(box);
    box.clear();
    for (const RowChoice& entry : entries) box.addItem(entry.text, entry.value);
    box.setCurrentIndex(std::max(0, box.findData(before)));
}

void choose(ChoiceBox& box, int value) {
    const QSignalBlocker quiet(box);
    if (const int index = box.findData(value); index >= 0) box.setCurrentIndex(index);
}

int chosenValue(const ChoiceBox& box) {
    return box.currentData().toInt();
}

QuantityField* addQuantity(QFormLayout& form, const RowWords& words, Quantity quantity, const char* unit,
                           FieldRange range, std::optional<double> si, std::function<void()> changed) {
    auto* row = new QWidget(form.parentWidget());
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* field = new QuantityField(quantity, *findUnit(quantity, unit), row);
    nameControl(*field, words);
    field->setValue(si);
    QObject::connect(field, &QuantityField::problemShown, field, changed);
    QObject::connect(field, &QuantityField::cleared, field, changed);
    field->setTaker([range, changed = std::move(changed)](double value) {
        const QString refusal = objection(range, value);
        if (refusal.isEmpty()) changed();
        return refusal;
    });
    layout->addWidget(field, 1);
    if (field->unitButton()) {
        field->unitButton()->setAccessibleName(tr("%1: unit").arg(words.label));
        layout->addWidget(field->unitButton());
    }
    auto* label = new QLabel(words.label, form.parentWidget());
    label->setBuddy(field);
    form.addRow(label, row);
    return field;
}

QSpinBox* addCount(QFormLayout& form, const RowWords& words, int least, int most, int value) {
    auto* box = new QSpinBox(form.parentWidget());
    nameControl(*box, words);
    box->setRange(least, most);
    box->setValue(value);
    box->setKeyboardTracking(false);
    ignoreUnfocusedWheel(*box);
    form.addRow(words.label, box);
    return box;
}

void setRowVisible(QFormLayout& form, QWidget& control, bool visible) {
    QWidget* inForm = form.indexOf(&control) >= 0 ? &control : control.parentWidget();
    form.setRowVisible(inForm, visible);
}

GaugeRows::GaugeRows(QFormLayout& form, const std::function<void()>& changed) : m_form(form) {
    m_bar = addChoice(form, {"bar", tr("gauge is on"), tr("Bar used to convert strain to force")},
                      {{tr("the rod or string"), ofScenario}, {tr("another bar"), otherBar}});
    m_modulus = addQuantity(form, {"modulus", tr("E of the bar"), tr("Young's modulus")}, Quantity::stress,
                            "GPa", FieldRange::positive, 210e9, changed);
    m_diameter = addQuantity(form, {"diameter", tr("diameter"), tr("Diameter of the solid bar at the gauge")},
                             Quantity::length, "mm", FieldRange::positive, 0.02, changed);
    m_gaugeFactor =
        addQuantity(form, {"gaugeFactor", tr("gauge factor k"), tr("Relative resistance over strain")},
                    Quantity::ratio, "", FieldRange::positive, 2, changed);
    m_density =
        addQuantity(form, {"density", tr("density"), tr("The impedance of the bar is its area times √(E ρ)")},
                    Quantity::density, "kg/m^3", FieldRange::positive, 7850, changed);
    m_bridgeFactor =
        addQuantity(form,
                    {"bridgeFactor", tr("bridge factor"),
                     tr("Active gauges: 1 quarter, 2 half, 4 full bridge; 2.6 full bridge with two "
                        "gauges across a bar of Poisson's ratio 0.3")},
                    Quantity::ratio, "", FieldRange::positive, 1, changed);
    m_gain = addQuantity(form, {"gain", tr("gain"), tr("Volts out of the amplifier over volts in")},
                         Quantity::ratio, "", FieldRange::positive, 1, changed);
    m_excitation = addQuantity(form, {"excitation", tr("excitation in V"), tr("Supply of the bridge")},
                               Quantity::ratio, "", FieldRange::positive, {}, changed);
    m_excitation->setOptional(tr("not given"));
    m_forcePerVolt = addQuantity(
        form, {"forcePerVolt", tr("force per volt"), tr("Result of a calibration; it overrides the bridge")},
        Quantity::force, "kN", FieldRange::notZero, {}, changed);
    m_forcePerVolt->setOptional(tr("not given"));
    m_fields = {m_modulus,      m_diameter, m_gaugeFactor, m_density,
                m_bridgeFactor, m_gain,     m_excitation,  m_forcePerVolt};
    QObject::connect(m_bar, &QComboBox::currentIndexChanged, m_bar, changed);
}

void GaugeRows::offerScenario(bool offered) {
    m_isOffered = offered;
    if (!offered) choose(*m_bar, otherBar);
}

bool GaugeRows::isOnScenario() const {
    return m_isOffered && chosenValue(*m_bar) == ofScenario;
}

void GaugeRows::show(SignalKind kind) {
    const bool isVoltage = kind == SignalKind::voltage;
    const bool isCalibrated = isVoltage && m_forcePerVolt->value();
    const bool needsBar = kind != SignalKind::force && !isCalibrated;
    const bool typed = needsBar && !isOnScenario();
    const bool hasBridge = kind == SignalKind::bridge || (isVoltage && !isCalibrated);
    setRowVisible(m_form, *m_bar, needsBar && m_isOffered);
    setRowVisible(m_form, *m_modulus, typed && kind != SignalKind::stress);
    setRowVisible(m_form, *m_diameter, typed);
    setRowVisible(m_form, *m_density, typed && kind == SignalKind::velocity);
    setRowVisible(m_form, *m_gaugeFactor, hasBridge);
    setRowVisible(m_form, *m_bridgeFactor, hasBridge);
    setRowVisible(m_form, *m_forcePerVolt, isVoltage);
    setRowVisible(m_form, *m_gain, isVoltage && !isCalibrated);
    setRowVisible(m_form, *m_excitation, isVoltage && !isCalibrated);
}

QString GaugeRows::problem(SignalKind kind) const {
    if (kind != SignalKind::voltage || m_forcePerVolt->value() || m_excitation->value()) return {};
    return tr(
        "Volts are no forces: type the force per volt of a calibration, or the excitation of the bridge.");
}

void GaugeRows::use(const SignalOptions& settings, SignalKind kind) {
    if (settings.area || settings.modulus) {
        choose(*m_bar, otherBar);
        if (settings.area) m_diameter->setValue(std::sqrt(4 / std::numbers::pi * *settings.area));
        if (settings.modulus) m_modulus->setValue(settings.modulus);
    }
    if (settings.gaugeFactor) m_gaugeFactor->setValue(settings.gaugeFactor);
    if (settings.bridge) m_bridgeFactor->setValue(settings.bridge);
    if (settings.gain) m_gain->setValue(settings.gain);
    if (settings.excitation) m_excitation->setValue(settings.excitation);
    if (kind == SignalKind::voltage && settings.scale && settings.scale->isPerUnit)
        m_forcePerVolt->setValue(settings.scale->factor);
}

void GaugeRows::addTo(SignalOptions& settings, SignalKind kind) const {
    const bool isVoltage = kind == SignalKind::voltage;
    if (isVoltage && m_forcePerVolt->value()) {
        settings.scale = SignalScale{*m_forcePerVolt->value(), true};
        return;
    }
    if (kind != SignalKind::force && !isOnScenario()) {
        const double diameter = *m_diameter->value();
        settings.area = std::numbers::pi / 4 * diameter * diameter;
        settings.modulus = m_modulus->value();
    }
    if (kind == SignalKind::bridge || isVoltage) {
        settings.gaugeFactor = m_gaugeFactor->value();
        settings.bridge = m_bridgeFactor->value();
    }
    if (isVoltage) {
        settings.gain = m_gain->value();
        settings.excitation = m_excitation->value();
    }
}

GaugedBar GaugeRows::bar(const GaugedBar& ofScenario) const {
    const double diameter = *m_diameter->value();
    GaugedBar bar = ofScenario;
    if (!isOnScenario()) {
        bar.area = std::numbers::pi / 4 * diameter * diameter;
        bar.axialStiffness = *m_modulus->value() * bar.area;
        bar.impedance = bar.area * std::sqrt(*m_modulus->value() * *m_density->value());
    }
    bar.gaugeFactor = *m_gaugeFactor->value();
    bar.activeGauges = *m_bridgeFactor->value();
    bar.gain = *m_gain->value();
    bar.excitation = m_excitation->value().value_or(1);
    bar.forcePerVolt = m_forcePerVolt->value().value_or(0);
    return bar;
}

}  // namespace drillwave
