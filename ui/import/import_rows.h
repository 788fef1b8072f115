// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of a form of choices: each control with its label, name and explanation.
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

/// Name and explanation of a row.
struct RowWords {
    const char* name;  ///< of the control, for tests
    QString label;
    QString toolTip;
};

/// An entry of a choice, and what it stands for.
struct RowChoice {
    QString text;
    int value = 0;
};

/// A choice of one of the entries.
ChoiceBox* addChoice(QFormLayout& form, const RowWords& words, const QList<RowChoice>& entries);
/// Replaces the entries and keeps the value if it is among them, else selects the first. Emits nothing.
void setEntries(ChoiceBox& box, const QList<RowChoice>& entries);
/// Tells nobody; no effect where there is no such value.
void choose(ChoiceBox& box, int value);
int chosenValue(const ChoiceBox& box);

/// Which finite numbers a field takes.
enum class FieldRange { any, notNegative, positive, notZero };
/// `changed` is called with every value, and when its text is refused or is so no more.
QuantityField* addQuantity(QFormLayout& form, const RowWords& words, Quantity quantity, const char* unit,
                           FieldRange range, std::optional<double> si, std::function<void()> changed);

QSpinBox* addCount(QFormLayout& form, const RowWords& words, int least, int most, int value);

/// Shows or hides the row of a control with its unit button.
void setRowVisible(QFormLayout& form, QWidget& control, bool visible);

// Rows that convert strain to force: the bar with the gauge, and the bridge.

/// Rows of a form, which owns their controls and must outlive this.
class GaugeRows {
    Q_DECLARE_TR_FUNCTIONS(GaugeRows)

  public:
    /// `changed` is called with every choice and every value.
    GaugeRows(QFormLayout& form, const std::function<void()>& changed);

    /// Whether the gauge may be on the rod or string of the scenario; else it is on another bar.
    void offerScenario(bool offered);
    /// Shows what such numbers need, and no more.
    void show(SignalKind kind);
    /// `ofScenario`: the rod or string where the gauge is, where it is offered.
    GaugedBar bar(const GaugedBar& ofScenario) const;
    /// Returns the question that is open about a bridge or an amplifier; empty when all is known.
    QString problem(SignalKind kind) const;
    /// Takes what settings give; `kind`: what the numbers are.
    void use(const SignalOptions& settings, SignalKind kind);
    /// Sets what numbers of that kind need.
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
