// SPDX-License-Identifier: GPL-3.0-or-later
// Code that must not compile: a value without a name. With ALL_NAMED it has one.
#include "core/text/enum_names.h"

enum class Season { spring, summer, autumn };

constexpr drillwave::EnumNames<Season> seasons{{
    {Season::spring, "spring"},
    {Season::summer, "summer"},
#ifdef ALL_NAMED
    {Season::autumn, "autumn"},
#endif
}};
static_assert(seasons[Season::summer] == "summer");
