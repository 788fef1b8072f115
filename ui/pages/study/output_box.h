// SPDX-License-Identifier: GPL-3.0-or-later
// A list to choose the result that a study evaluates.
#pragma once

#include "core/blow/outputs.h"
#include "ui/form/choice_box.h"

namespace drillwave {

/// Outputs that a study offers. `ofOneBlow` leaves out outputs such as thrust_margin. For each value these
/// need many blows, at all gaps between bit and rock.
enum class OfferedOutputs { all, ofOneBlow };

/// List box of the outputs (computed results) of a scenario. At first the coefficient of restitution is
/// selected, or the efficiency for a drill string.
class OutputBox : public ChoiceBox {
    Q_OBJECT

  public:
    explicit OutputBox(QWidget* parent = nullptr, OfferedOutputs offered = OfferedOutputs::all);

    /// Offers the outputs of the scenario. The user's choice is kept if the scenario has it; otherwise the
    /// default is selected.
    void present(const Scenario& scenario);
    const Output& output() const;
    /// Selects an output as if the user had chosen it. Requires that the scenario has it.
    void setOutput(const Output& output);

  signals:
    /// Reports that output() has changed.
    void changed();

  private:
    OfferedOutputs m_offered;
    QString m_shown;
    bool m_isChosen = false;  // whether the output was chosen by the user or by setOutput()
};

/// Returns the name of an output for lists and axes, such as "peak force" or "COR e".
QString outputName(const Output& output);

}  // namespace drillwave
