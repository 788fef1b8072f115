// SPDX-License-Identifier: GPL-3.0-or-later
// Error against run time told to people.
#pragma once

#include <string>

#include "core/model/scenario.h"
#include "core/study/proof/accuracy.h"

namespace drillwave {

/// A table for people, with what its columns mean and what the checks show.
std::string accuracyText(const Scenario& scenario, const Accuracy& accuracy);

}  // namespace drillwave
