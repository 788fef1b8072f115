// SPDX-License-Identifier: GPL-3.0-or-later
// The summary of a blow on a drill string for people.
#pragma once

#include <string>

#include "core/blow/blow.h"

namespace drillwave {

/// Results, where the energy of the hammer went, and the largest stresses of each section. Of a solved blow
/// on a drill string.
std::string stringResultText(const Blow& blow);

}  // namespace drillwave
