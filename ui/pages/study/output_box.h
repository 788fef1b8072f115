// SPDX-License-Identifier: GPL-3.0-or-later
// Which result a study looks at.
#pragma once

#include "core/blow/outputs.h"
#include "ui/form/choice_box.h"

namespace drillwave {

/// Which outputs a study can have: thrust_margin takes a study of all gaps for every value.
enum class OfferedOutputs { all, ofOneBlow };

/// The outputs that a scenario has; e at first, of a drill string the efficiency.
class OutputBox : public ChoiceBox {
    Q_OBJECT

  public:
    explicit OutputBox(QWidget* parent = nullptr, OfferedOutputs offered = OfferedOutputs::all);

    /// Offers what the scenario has; what is chosen stays where it has that, and is the first one otherwise.
    void present(const Scenario& scenario);
    const Output& output() const;
    /// As if the user had chosen it. Requires that the scenario has it.
    void setOutput(const Output& output);

  signals:
    /// output() is another one.
    void changed();

  private:
    OfferedOutputs m_offered;
    QString m_shown;
    bool m_isChosen = false;  // by the user, or by setOutput()
};

/// "peak force", "COR e": as a box or an axis calls it.
QString outputName(const Output& output);

}  // namespace drillwave
