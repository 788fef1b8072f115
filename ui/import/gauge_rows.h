// SPDX-License-Identifier: GPL-3.0-or-later
// What makes a force of a strain: the bar that a gauge is on, and the bridge that it is in.
#pragma once

#include <QCoreApplication>
#include <QList>
#include <functional>
#include <optional>

#include "core/model/scenario.h"
#include "core/signal/signal_unit.h"

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

    /// The rod that the gauge may be on; without one it is on another bar.
    void setRod(const std::optional<Rod>& rod);
    const std::optional<Rod>& rod() const { return m_rod; }
    /// Shows what such numbers need, and no more.
    void show(SignalKind kind);
    GaugedBar bar() const;
    const QList<QuantityField*>& fields() const { return m_fields; }

  private:
    double axialStiffness() const;

    QFormLayout& m_form;
    std::optional<Rod> m_rod;
    ChoiceBox* m_bar;
    QuantityField* m_modulus;
    QuantityField* m_diameter;
    QuantityField* m_gaugeFactor;
    ChoiceBox* m_activeGauges;
    QList<QuantityField*> m_fields;
};

}  // namespace drillwave
