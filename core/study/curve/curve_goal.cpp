// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/curve/curve_goal.h"

#include <algorithm>

#include "core/text/enum_names.h"

namespace drillwave {

std::string_view name(GoalPlace::Kind kind) {
    using enum GoalPlace::Kind;
    static constexpr EnumNames<GoalPlace::Kind> names{{{crossing, "crossing"},
                                                       {touch, "touch"},
                                                       {end, "end"},
                                                       {everywhere, "everywhere"},
                                                       {between, "between_points"},
                                                       {jump, "jump"}}};
    return names[kind];
}

bool GoalAnswer::isReached() const {
    return std::ranges::any_of(places, &GoalPlace::isGiven);
}

}  // namespace drillwave
