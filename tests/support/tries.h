// SPDX-License-Identifier: GPL-3.0-or-later
// Amount of a long test that runs: a part chosen by the seed for every change, all of it at night.
#pragma once

#include <QtGlobal>

namespace drillwave::test {

/// Returns true where every case runs: DRILLWAVE_NIGHTLY=1, as in the tests labelled `nightly`.
inline bool isNightly() {
    return qEnvironmentVariableIntValue("DRILLWAVE_NIGHTLY") > 0;
}

/// Returns the seed that chooses the part of a long test: DRILLWAVE_SEED, by default 0. `packaging/test` sets
/// it to the number of the commit, so that each case runs once within as many commits as there are parts.
inline int seed() {
    return qEnvironmentVariableIntValue("DRILLWAVE_SEED");
}

/// Returns whether case `index` (from 0) of a long test runs when the seed chooses one of `parts` parts. Odd
/// numbers of parts meet both locales, which alternate by the same seed.
inline bool isChosen(int index, int parts) {
    return isNightly() || (index + seed()) % parts == 0;
}

/// Returns how often something random is tried: the value of the environment variable where it is set, `all`
/// at night, otherwise `few`, which takes seconds at most.
inline int tries(const char* variable, int few, int all) {
    const int set = qEnvironmentVariableIntValue(variable);
    return set > 0 ? set : isNightly() ? all : few;
}

/// Returns how often a short test tries something random: `count` by day and at night.
inline int tries(const char* variable, int count) {
    return tries(variable, count, count);
}

}  // namespace drillwave::test
