// SPDX-License-Identifier: GPL-3.0-or-later
// Outputs of a blow as the window writes them.
#pragma once

#include <QString>

#include "core/blow/outputs.h"
#include "ui/job/solved_blow.h"

namespace drillwave {

/// An output in the units of the blow; empty where there is none.
QString outputText(const Output& output, const SolvedBlow& blow);

/// Where in the rod a largest force is, and when. Empty where there is none.
QString placeText(const Output& output, const SolvedBlow& blow);

}  // namespace drillwave
