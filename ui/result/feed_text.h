// SPDX-License-Identifier: GPL-3.0-or-later
// The thrust that a blow needs, and the judgement on the installed one, as the window writes them: empty
// where the scenario does not say enough.
#pragma once

#include <QString>
#include <optional>

#include "ui/job/solved_blow.h"
#include "ui/result/worst_need.h"

namespace drillwave {

/// The bracket of what this blow needs: full penetration, to the bit back in time without a damper.
QString thrustNeededText(const SolvedBlow& blow);

/// The largest of four needs; marked by an ellipsis while it is not of this blow.
QString worstNeedText(const WorstNeed& worst, const SolvedBlow& blow);

/// Whether what is installed reaches that, with the difference in words and as a share: "⚠ short by …". Empty
/// where either is not known, an ellipsis where the need is not of this blow.
QString worstMarginText(const WorstNeed& worst, const SolvedBlow& blow);
/// Whether it is known to be less.
bool isShortOfWorst(const WorstNeed& worst, const SolvedBlow& blow);

/// The installed thrust, and the effective force where weight along the hole counts.
QString thrustInstalledText(const SolvedBlow& blow);

/// What is installed beyond full penetration [N]; below zero what is missing.
std::optional<double> thrustMargin(const SolvedBlow& blow);

/// The same in words, and as a share of what full penetration needs.
QString thrustMarginText(const SolvedBlow& blow);

/// By how much a margin is off another one [N], in the unit of the blow: "+1.27 kN". A margin passes through
/// zero, where a share of it says nothing.
QString marginChangeText(double margin, double reference, const SolvedBlow& blow);

/// The verdict in a few words, and what it means at the rig.
QString feedText(const SolvedBlow& blow);
QString feedMeaningText(const SolvedBlow& blow);

/// The sentence to act on; with an ellipsis while what more than this blow needs is not known. Empty where
/// the blow is not solved.
QString decisionText(const WorstNeed& worst, const SolvedBlow& blow);

}  // namespace drillwave
