// SPDX-License-Identifier: GPL-3.0-or-later
// How often what is random is tried: some for every run of the tests, more by hand.
#pragma once

#include <QtGlobal>

namespace drillwave::test {

/// As many as the variable says; `few`, which take seconds, where it says nothing.
inline int tries(const char* variable, int few) {
    const int asked = qEnvironmentVariableIntValue(variable);
    return asked > 0 ? asked : few;
}

}  // namespace drillwave::test
