// SPDX-License-Identifier: GPL-3.0-or-later
// The required and the installed feed, as the window writes them: empty if the scenario lacks
// data.
#pragma once

#include <QString>
#include <QTimer>
#include <optional>

#include "core/study/thrust/thrust_study.h"
#include "ui/job/solved_blow.h"
#include "ui/job/study_job.h"

namespace drillwave {

// The required feed of all four cases, which takes a study of all gaps, in addition to the blow.

/// Follows the blow on show as soon as its values rest. Keeps the estimate of the earlier one until then.
class WorstNeed : public QObject {
    Q_OBJECT

  public:
    explicit WorstNeed(QObject* parent = nullptr);

    /// Starts the study for a blow; one without a thrust has no estimate.
    void ask(const SolvedBlow& blow);
    /// Stops following blows until the next ask().
    void askNothing();
    /// The estimate of all four cases; nothing where there is none, or none yet.
    std::optional<FeedEstimate> estimate() const;
    /// The largest of the four required forces [N]; nothing where there is none, or none yet.
    std::optional<double> thrust() const;
    /// Why there is none, in a sentence; may be empty.
    QString problem() const;
    /// Whether estimate() is that of the last blow.
    bool isCurrent() const;
    /// Whether it is on its way.
    bool isAwaited() const;

  signals:
    void changed();

  private:
    void ask(std::optional<Scenario> scenario);
    void run();

    std::optional<Scenario> m_scenario;  // with a thrust
    StudyJob<ThrustStudy> m_job;
    bool m_due = false;  // requested, and not run yet
    QTimer m_rest;
};

/// The force that this blow requires, f I0 (1+e), and the feed at which an undamped rigid rod is back in
/// time.
QString thrustNeededText(const SolvedBlow& blow);
QString returnInTimeText(const SolvedBlow& blow);

/// The largest of the four required forces; marked by an ellipsis while it is not of this blow.
QString worstNeedText(const WorstNeed& worst, const SolvedBlow& blow);

/// Whether what is installed reaches that, with the difference in words and as a share: "⚠ short by …". Empty
/// where either is not known, an ellipsis where the need is not of this blow.
QString worstMarginText(const WorstNeed& worst, const SolvedBlow& blow);
/// Whether it is known to be less.
bool isShortOfWorst(const WorstNeed& worst, const SolvedBlow& blow);

/// The installed thrust, and the effective force where weight along the hole counts.
QString thrustInstalledText(const SolvedBlow& blow);

/// The installed force less what this blow requires [N]; below zero what is missing.
std::optional<double> thrustMargin(const SolvedBlow& blow);

/// Formats the margin, also as a share of the required feed.
QString thrustMarginText(const SolvedBlow& blow);

/// Formats the difference of two margins [N], in the unit of the blow: "+1.27 kN". A margin passes through
/// zero, where a share of it has no meaning.
QString marginChangeText(double margin, double reference, const SolvedBlow& blow);

/// The estimate by which the feed is judged, and whether its cases of all gaps are on their way.
struct FeedEstimateOnShow {
    std::optional<FeedEstimate> estimate = {};
    bool isAwaited = false;
};
FeedEstimateOnShow estimateOnShow(const WorstNeed& worst, const SolvedBlow& blow);

/// The required feed of single blows in one sentence; with an ellipsis while it is awaited. Empty where
/// the blow is not solved.
QString requiredText(const FeedEstimateOnShow& shown, const SolvedBlow& blow);

}  // namespace drillwave
