// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/result/worst_need.h"

#include "core/blow/feed_estimate.h"
#include "core/model/blow_traits.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

// While values are dragged the study would only take the time of the blows.
constexpr std::chrono::milliseconds blowRest{100};

}  // namespace

WorstNeed::WorstNeed(QObject* parent) : QObject(parent) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(blowRest);
    connect(&m_rest, &QTimer::timeout, this, &WorstNeed::run);
    connect(&m_job, &StudyActivity::changed, this, &WorstNeed::changed);
}

void WorstNeed::ask(const SolvedBlow& blow) {
    std::optional<Scenario> asked;
    if (blow.fault.isEmpty() && gapHasPeriod(blow.request.scenario) &&
        thrustProblem(blow.request.scenario).isEmpty()) {
        asked = blow.request.scenario;
        asked->title.clear();
    }
    ask(std::move(asked));
}

void WorstNeed::askNothing() {
    ask(std::optional<Scenario>());
}

void WorstNeed::ask(std::optional<Scenario> scenario) {
    if (scenario == m_scenario) return;
    m_scenario = std::move(scenario);
    m_due = m_scenario.has_value();
    if (m_due)
        m_rest.start();
    else
        m_rest.stop();
    m_job.cancel();
}

void WorstNeed::run() {
    m_due = false;
    m_job.submit([scenario = *m_scenario](const StudyFeed<ThrustStudy>& feed) {
        return studyThrust(scenario, feed.stop);
    });
}

std::optional<FeedEstimate> WorstNeed::estimate() const {
    const auto& study = m_job.value();
    if (!m_scenario || !study || !study->reason.isEmpty() || study->stopped) return std::nullopt;
    return study->feed;
}

std::optional<double> WorstNeed::thrust() const {
    const std::optional<FeedEstimate> found = estimate();
    return found ? std::optional(found->largest().thrust) : std::nullopt;
}

QString WorstNeed::problem() const {
    const auto& study = m_job.value();
    return study ? translated(study->reason) : m_job.problem();
}

bool WorstNeed::isAwaited() const {
    return m_scenario && (m_due || m_job.state() == StudyState::running);
}

bool WorstNeed::isCurrent() const {
    return !m_due && m_job.isCurrent() && m_job.state() != StudyState::running;
}

}  // namespace drillwave
