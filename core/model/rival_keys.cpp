// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/rival_keys.h"

#include <algorithm>
#include <array>
#include <utility>

namespace drillwave {
namespace {

constexpr auto rivals = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"bit_rock.stiffness", "beta"},
    {"bit_rock.gamma", "gamma"},
    {"bit_rock.gap", "delta"},
    {"rod.length", "tau"},
    {"rod.area", "rod.diameter"},
    {"rod.area", "rod.bore"},
    {"pulse.impulse", "pulse.force"},
});

}  // namespace

bool areRivals(std::string_view a, std::string_view b) {
    return a == b || std::ranges::any_of(rivals, [&](const auto& pair) {
               return pair == std::pair(a, b) || pair == std::pair(b, a);
           });
}

}  // namespace drillwave
