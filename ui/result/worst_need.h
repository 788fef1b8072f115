// SPDX-License-Identifier: GPL-3.0-or-later
// The required feed of all four cases, which takes a study of all gaps: found beside the blow.
#pragma once

#include <QTimer>
#include <optional>

#include "core/study/thrust/thrust_study.h"
#include "ui/job/solved_blow.h"
#include "ui/job/study_job.h"

namespace drillwave {

/// Follows the blow on show as soon as its values rest. What was found for an earlier one stays meanwhile.
class WorstNeed : public QObject {
    Q_OBJECT

  public:
    explicit WorstNeed(QObject* parent = nullptr);

    /// Of this blow from now on; one without a thrust has none.
    void ask(const SolvedBlow& blow);
    /// Of no blow, until it is asked again.
    void askNothing();
    /// The estimate of all four cases; nothing where there is none, or none yet.
    std::optional<FeedEstimate> estimate() const;
    /// The largest of the four required forces [N], likewise.
    std::optional<double> thrust() const;
    /// Why there is none, in a sentence; may be empty.
    QString problem() const;
    /// Whether estimate() is that of the blow asked for last.
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
    bool m_due = false;  // asked, and not run yet
    QTimer m_rest;
};

}  // namespace drillwave
