// SPDX-License-Identifier: GPL-3.0-or-later
// What makes a force of a strain: the bar that a gauge is on, and the bridge that it is in.
#pragma once

#include <QCoreApplication>
#include <QList>
#include <functional>

#include "core/signal/signal_reading.h"

class QFormLayout;

namespace drillwave {

class ChoiceBox;
class QuantityField;

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
