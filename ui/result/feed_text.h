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

/// Estimate of the feed force required by four cases: this blow, rigid rock, 95 % of all gaps, and the worst
/// gap. It is computed when the values have not changed for a moment. The previous estimate is kept until
/// then.
class WorstNeed : public QObject {
    Q_OBJECT

  public:
    explicit WorstNeed(QObject* parent = nullptr);

    /// Requests the estimate for a blow. It exists only for a solved blow on a uniform rod with a blow
    /// frequency.
    void ask(const SolvedBlow& blow);
    /// Stops requesting estimates until the next ask().
    void askNothing();
    /// Returns the estimate of the required feed force for all four cases; nothing if there is none, or none
    /// yet. The cases are this blow, rigid rock, 95 % of all gaps and the worst gap.
    std::optional<FeedEstimate> estimate() const;
    /// Returns the largest feed force [N] required by this blow, rigid rock, 95 % of all gaps and the worst
    /// gap. Nothing if it is not known, or not yet.
    std::optional<double> thrust() const;
    /// Returns a sentence that says why there is no estimate; may be empty.
    QString problem() const;
    /// Returns whether estimate() belongs to the last blow.
    bool isCurrent() const;
    /// Returns whether an estimate is being computed or will be soon.
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

/// Returns the feed force required by this blow, f I0 (1 + e), with its unit; empty without data.
QString thrustNeededText(const SolvedBlow& blow);
/// Returns the feed force for which an undamped rigid rod returns in time, f I0 (1 + 2e), with its unit;
/// empty without data.
QString returnInTimeText(const SolvedBlow& blow);

/// Returns WorstNeed::thrust(), the largest required feed force, with its unit. An ellipsis is added while
/// the value is that of an earlier scenario; empty if it is not known.
QString worstNeedText(const WorstNeed& worst, const SolvedBlow& blow);

/// Returns whether the effective feed force covers WorstNeed::thrust(), the largest required one, in words
/// with the difference, such as "⚠ short by …". Empty if one of them is not known; an ellipsis while the
/// estimate is that of an earlier scenario.
QString worstMarginText(const WorstNeed& worst, const SolvedBlow& blow);
/// Returns whether the effective feed force is known to be less than WorstNeed::thrust(), the largest
/// required one.
bool isShortOfWorst(const WorstNeed& worst, const SolvedBlow& blow);

/// Returns the installed feed force with its unit, and the effective feed force if weight along the hole is
/// given.
QString thrustInstalledText(const SolvedBlow& blow);

/// Returns the effective feed force minus the force required by this blow [N]; negative if it is too small.
/// Nothing without data.
std::optional<double> thrustMargin(const SolvedBlow& blow);

/// Returns thrustMargin() with its unit, and as a share of the required force [%].
QString thrustMarginText(const SolvedBlow& blow);

/// Returns the difference of two margins [N] with sign, in the force unit of the blow: "+1.27 kN". It has no
/// percentage, because a margin can be zero.
QString marginChangeText(double margin, double reference, const SolvedBlow& blow);

/// Estimate of the required feed force with which the installed feed force is compared. `isAwaited` is true
/// while an estimate from blows at all gaps is still being computed.
struct FeedEstimateOnShow {
    std::optional<FeedEstimate> estimate = {};
    bool isAwaited = false;
};
/// Returns the estimate of the required feed force from blows at all gaps, if it was computed for this blow.
/// Otherwise returns the estimate from this blow only.
FeedEstimateOnShow estimateOnShow(const WorstNeed& worst, const SolvedBlow& blow);

/// Returns one sentence on the feed force required by single blows, with an ellipsis while a better estimate
/// is computed. Empty if the blow is not solved.
QString requiredText(const FeedEstimateOnShow& shown, const SolvedBlow& blow);

}  // namespace drillwave
