// SPDX-License-Identifier: GPL-3.0-or-later
// Names of parameters, and lists to choose a parameter from.
#pragma once

#include <QString>

#include "core/model/parameter.h"

class QComboBox;

namespace drillwave {

/// Returns the name of a parameter for lists and axes, such as "stiffness k".
QString parameterName(const Parameter& parameter);

/// Subject of a study: one blow, or many blows. Studies of one blow do not offer parameters that affect only
/// many blows.
enum class StudyOf { oneBlow, manyBlows };

/// Fills a list with the parameters that apply to the scenario; the item data are their keys. Items without a
/// key stay at the top, and the selected parameter stays selected if it still applies. Emits no signals.
void offerParameters(QComboBox& box, const Scenario& scenario, StudyOf of = StudyOf::oneBlow);

/// Returns the selected parameter; nullptr if none is selected.
KeptParameter chosenParameter(const QComboBox& box);

/// Selects a parameter. For nullptr it selects the first item, which stands for none. Emits no signals.
void chooseParameter(QComboBox& box, const KeptParameter& parameter);

}  // namespace drillwave
