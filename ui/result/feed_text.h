// SPDX-License-Identifier: GPL-3.0-or-later
// Required and installed feed force as texts for the window; empty if the scenario lacks the necessary data.
#pragma once

#include <QString>
#include <QTimer>
#include <optional>

#include "core/study/thrust/thrust_study.h"
#include "ui/job/solved_blow.h"
#include "ui/job/study_job.h"

namespace drillwave {

// The required feed force of all four cases, which needs a study of all gaps in addition to the blow.

/// Estimate of the feed force required in four cases: this blow, rigid rock, 95 % of all gaps between bit and
/// rock, and the worst gap. It is computed when the input has not changed for a moment. The previous estimate
/// is kept until then.
class WorstNeed : public QObject {
    Q_OBJECT

  public:
    explicit WorstNeed(QObject* parent = nullptr);

    /// Requests the estimate for the scenario of a blow. There is none unless the blow is solved, the string
    /// is a uniform rod and a blow frequency is given.
    void ask(const SolvedBlow& blow);
    /// Withdraws the request for an estimate, because there is no blow to estimate. estimate() then returns
    /// nothing until the next ask().
    void askNothing();
    /// Returns the required feed force in four cases: this blow, rigid rock, 95 % of all gaps between bit and
    /// rock, and the worst gap. Nothing if there is no estimate, or none yet.
    std::optional<FeedEstimate> estimate() const;
    /// Returns the largest feed force [N] required in four cases: this blow, rigid rock, 95 % of all gaps
    /// between bit and rock, and the worst gap. Nothing if it is not known or not computed yet.
    std::optional<double> thrust() const;
    /// Returns a sentence that says why the required feed force cannot be estimated; empty if there is no
    /// such reason.
    QString problem() const;
    /// Returns whether the computation for the blow last passed to ask() is finished. False while estimate()
    /// is that of an earlier blow.
    bool isCurrent() const;
    /// Returns whether an estimate of the required feed force is being computed, or will be soon.
    bool isAwaited() const;

  signals:
    void changed();

  private:
    void ask(std::optional<Scenario> scenario);
    void run();

    std::optional<Scenario> m_scenario;  // scenario to estimate; empty if it has none
    StudyJob<ThrustStudy> m_job;
    bool m_due = false;  // whether an estimate is requested but not yet started
    QTimer m_rest;
};

/// Returns the feed force required by this blow, f I0 (1 + e), with its unit. f is the blow frequency, I0 the
/// impulse of a blow and e the coefficient of restitution. Empty if the scenario lacks the data, such as the
/// blow frequency.
QString thrustNeededText(const SolvedBlow& blow);
/// Returns the feed force at which an undamped rigid rod returns to the rock in time for the next blow, f I0
/// (1 + 2e). f is the blow frequency, I0 the impulse of a blow. The text has a unit; it is empty if the
/// scenario lacks the data.
QString returnInTimeText(const SolvedBlow& blow);

/// Returns the largest required feed force, WorstNeed::thrust(), with its unit; empty if it cannot be
/// computed. During the computation it is the value of the earlier scenario (if any) in brackets, with an
/// ellipsis.
QString worstNeedText(const WorstNeed& worst, const SolvedBlow& blow);

/// Returns in words whether the effective feed force covers the largest required one, WorstNeed::thrust(),
/// and the difference, such as "⚠ short by …". Empty if one of them is not known; only an ellipsis during the
/// computation.
QString worstMarginText(const WorstNeed& worst, const SolvedBlow& blow);
/// Returns whether the effective feed force is less than the largest required one, WorstNeed::thrust(). False
/// if one of the two is not known.
bool isShortOfWorst(const WorstNeed& worst, const SolvedBlow& blow);

/// Returns the installed feed force with its unit. If the weight along the hole is known, the effective feed
/// force (installed force plus this weight) follows.
QString thrustInstalledText(const SolvedBlow& blow);

/// Returns the effective feed force minus the force required by this blow [N]; negative if it is too small.
/// Nothing without data.
std::optional<double> thrustMargin(const SolvedBlow& blow);

/// Returns the margin of the feed force, thrustMargin(), with its unit, and as a share of the force required
/// by this blow [%].
QString thrustMarginText(const SolvedBlow& blow);

/// Returns the difference of two margins of the feed force [N], with its sign, in the force unit of the blow:
/// "+1.27 kN". It has no percentage, because a margin can be zero.
QString marginChangeText(double margin, double reference, const SolvedBlow& blow);

/// Estimate of the required feed force as the window shows it. `isAwaited` is true while a better estimate,
/// from blows at all gaps between bit and rock, is still being computed.
struct FeedEstimateOnShow {
    std::optional<FeedEstimate> estimate = {};
    bool isAwaited = false;
};
/// Returns the required feed force to show for a blow. It is the estimate for all gaps between bit and rock,
/// if it was computed for this blow. Otherwise it is the estimate from this blow only.
FeedEstimateOnShow estimateOnShow(const WorstNeed& worst, const SolvedBlow& blow);

/// Returns one sentence on the feed force that single blows require. An ellipsis is added while a better
/// estimate is being computed. Empty if the blow is not solved.
QString requiredText(const FeedEstimateOnShow& shown, const SolvedBlow& blow);

}  // namespace drillwave
