// SPDX-License-Identifier: GPL-3.0-or-later
// A short sequence of the blow on show, followed beside it.
#pragma once

#include <QTimer>
#include <optional>

#include "core/study/drilling/quick_march.h"
#include "ui/job/solved_blow.h"
#include "ui/job/study_job.h"

namespace drillwave {

/// Follows consecutive blows as soon as the values rest, as many as fit into a second; where a hundred take
/// longer, only on request. The result of an earlier blow is not shown.
class ShortSequence : public QObject {
    Q_OBJECT

  public:
    explicit ShortSequence(QObject* parent = nullptr);

    /// Follows this blow from now on; one without feed and blow frequency has none.
    void ask(const SolvedBlow& blow);
    /// Follows the blows although they take longer.
    void follow();
    /// The result for the blow asked for last; nullptr while there is none.
    const DrillingResult* result() const;
    /// Whether it is on its way.
    bool isAwaited() const;
    /// How long it would take [s], where it waits for follow().
    std::optional<double> secondsOnRequest() const;

  signals:
    void changed();

  private:
    void start();

    std::optional<Scenario> m_scenario;  // that can be drilled with
    QuickMarch m_march;
    StudyJob<DrillingResult> m_job;
    bool m_isDue = false;  // asked, and not started yet
    bool m_isStarted = false;
    QTimer m_rest;
};

}  // namespace drillwave
