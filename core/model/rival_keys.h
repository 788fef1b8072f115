// SPDX-License-Identifier: GPL-3.0-or-later
// Keys that set the same thing.
#pragma once

#include <string_view>

namespace drillwave {

/// Whether setting one key undoes what setting the other did: the same key, a group and the physical
/// parameter it moves, mean force and impulse, area and diameters.
bool areRivals(std::string_view a, std::string_view b);

}  // namespace drillwave
