// SPDX-License-Identifier: GPL-3.0-or-later
// Choice of how much of a long test runs: one part, chosen by a seed, for every commit, and all of it at
// night.
#pragma once

#include <QtGlobal>

namespace drillwave::test {

/// Returns true if every case must run: the environment variable DRILLWAVE_NIGHTLY is 1, as in tests labelled
/// `nightly`.
inline bool isNightly() {
    return qEnvironmentVariableIntValue("DRILLWAVE_NIGHTLY") > 0;
}

/// Returns the seed that chooses the part of a long test: DRILLWAVE_SEED, by default 0. `packaging/test` sets
/// it to the number of the commit, so that each case runs once within as many commits as there are parts.
inline int seed() {
    return qEnvironmentVariableIntValue("DRILLWAVE_SEED");
}

/// Returns true if case `index` (from 0) of a long test runs when the seed chooses one of `parts` parts. An
/// odd number of parts covers both locales, which alternate with the seed.
inline bool isChosen(int index, int parts) {
    return isNightly() || (index + seed()) % parts == 0;
}

/// Returns the number of random tries: the value of the environment variable if set, `all` at night,
/// otherwise `few`, which should take seconds at most.
inline int tries(const char* variable, int few, int all) {
    const int set = qEnvironmentVariableIntValue(variable);
    return set > 0 ? set : isNightly() ? all : few;
}

/// Returns the number of random tries of a short test, which is `count` by day and at night.
inline int tries(const char* variable, int count) {
    return tries(variable, count, count);
}

}  // namespace drillwave::test
