// SPDX-License-Identifier: GPL-3.0-or-later
// The thrust that a blow needs, and the judgement on the installed one, as the window writes them: empty
// where the scenario does not say enough.
#pragma once

#include <QString>

#include "ui/job/solved_blow.h"
#include "ui/result/worst_need.h"

namespace drillwave {

/// The bracket of what this blow needs: full penetration, to the bit back in time without a damper.
QString thrustNeededText(const SolvedBlow& blow);

/// The largest of four needs; marked by an ellipsis while it is not of this blow.
QString worstNeedText(const WorstNeed& worst, const SolvedBlow& blow);

/// The installed thrust, and the effective force where weight along the hole counts.
QString thrustInstalledText(const SolvedBlow& blow);

/// What is installed beyond full penetration, and as a share of that.
QString thrustMarginText(const SolvedBlow& blow);

/// The verdict in a word or two, and in sentences.
QString feedText(const SolvedBlow& blow);
QString feedMeaning(const SolvedBlow& blow);

}  // namespace drillwave
