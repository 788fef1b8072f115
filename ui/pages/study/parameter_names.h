// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters in a box to choose from.
#pragma once

#include <QString>

#include "core/model/parameter.h"

class QComboBox;

namespace drillwave {

/// "stiffness k", as a box or an axis calls it.
QString parameterName(const Parameter& parameter);

/// Subject of a study: one blow, which parameters of many blows do not change, or many blows.
enum class StudyOf { oneBlow, manyBlows };

/// Fills the box with the parameters that apply to the scenario, keys as data, behind what it has without a
/// parameter; what is chosen stays chosen where it still applies. Tells nobody.
void offerParameters(QComboBox& box, const Scenario& scenario, StudyOf of = StudyOf::oneBlow);

/// Returns the selected parameter, or none.
KeptParameter chosenParameter(const QComboBox& box);

/// Chooses a parameter, or none. Tells nobody.
void chooseParameter(QComboBox& box, const KeptParameter& parameter);

}  // namespace drillwave
