// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of a form: each has a control with its label, name and explanation.
#pragma once

#include <QCoreApplication>
#include <QFormLayout>
#include <QList>
#include <QSpinBox>
#include <functional>

#include "core/signal/signal_reading.h"
#include "core/text/units.h"
#include "ui/form/choice_box.h"
#include "ui/form/quantity_field.h"

class QFormLayout;

namespace drillwave {

class ChoiceBox;
class QuantityField;

/// Texts of a form row: object name of its control, label and tooltip.
struct RowWords {
    const char* name;  ///< object name of the control, for tests
    QString label;
    QString toolTip;
};

/// Entry of a choice box, with the number for which it stands.
struct RowChoice {
    QString text;
    int value = 0;
};

/// Adds a form row with a choice box of the entries, and returns the box.
ChoiceBox* addChoice(QFormLayout& form, const RowWords& words, const QList<RowChoice>& entries);
/// Replaces the entries of a choice box. The chosen value stays if it is among them; otherwise the first
/// entry is chosen. Emits no signal.
void setEntries(ChoiceBox& box, const QList<RowChoice>& entries);
/// Selects the entry that stands for the number `value`, without emitting a signal. Does nothing if there is
/// none.
void choose(ChoiceBox& box, int value);
int chosenValue(const ChoiceBox& box);

/// Range of numbers that an input field accepts. They are always finite.
enum class FieldRange { any, notNegative, positive, notZero };
/// Adds a form row with a field for a quantity, and returns the field. `unit` is the initial unit, `si` the
/// initial value in SI units. `changed` is called for every new value, and when the text of the field becomes
/// invalid or valid.
QuantityField* addQuantity(QFormLayout& form, const RowWords& words, Quantity quantity, const char* unit,
                           FieldRange range, std::optional<double> si, std::function<void()> changed);

/// Adds a form row with a box for a whole number from `least` to `most`, and returns the box.
QSpinBox* addCount(QFormLayout& form, const RowWords& words, int least, int most, int value);

/// Shows or hides the row of a control, including its unit button.
void setRowVisible(QFormLayout& form, QWidget& control, bool visible);

// Form rows for converting a strain gauge signal to force: the bar with the gauge, and the bridge.

/// Rows of a form for strain gauge, bridge and amplifier. The form owns their controls and must outlive this
/// object.
class GaugeRows {
    Q_DECLARE_TR_FUNCTIONS(GaugeRows)

  public:
    /// Adds the rows for the gauge to a form. `changed` is called after every choice and every new value.
    GaugeRows(QFormLayout& form, const std::function<void()>& changed);

    /// Offers the scenario's rod or string as the bar that carries the gauge. With false, the user can only
    /// enter another bar.
    void offerScenario(bool offered);
    /// Shows the rows that a signal of this kind needs, and hides the others.
    void show(SignalKind kind);
    /// Returns the data of bar and strain gauge bridge that convert the signal to force. If the user has
    /// chosen the scenario's rod or string as the bar, its data are taken from `ofScenario`.
    GaugedBar bar(const GaugedBar& ofScenario) const;
    /// Returns a message if a signal in volts cannot be converted: neither force per volt nor bridge
    /// excitation is entered. Empty otherwise.
    QString problem(SignalKind kind) const;
    /// Sets the form to the values in `settings`; fields without a given value stay unchanged. `kind` is the
    /// kind of signal, such as strain or voltage.
    void use(const SignalOptions& settings, SignalKind kind);
    /// Copies the values of the fields to `settings`, but only those that a signal of this kind needs.
    void addTo(SignalOptions& settings, SignalKind kind) const;
    const QList<QuantityField*>& fields() const { return m_fields; }

  private:
    bool isOnScenario() const;

    QFormLayout& m_form;
    bool m_isOffered = false;
    ChoiceBox* m_bar;
    QuantityField* m_modulus;
    QuantityField* m_diameter;
    QuantityField* m_gaugeFactor;
    QuantityField* m_density;
    QuantityField* m_bridgeFactor;
    QuantityField* m_gain;
    QuantityField* m_excitation;
    QuantityField* m_forcePerVolt;
    QList<QuantityField*> m_fields;
};

}  // namespace drillwave
