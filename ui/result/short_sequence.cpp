// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/result/short_sequence.h"

#include "core/blow/feed_estimate.h"

namespace drillwave {
namespace {

// While values are dragged it would only take the time of the blows.
constexpr std::chrono::milliseconds sequenceRest{250};

}  // namespace

ShortSequence::ShortSequence(QObject* parent) : QObject(parent) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(sequenceRest);
    connect(&m_rest, &QTimer::timeout, this, &ShortSequence::start);
    connect(&m_job, &StudyActivity::changed, this, &ShortSequence::changed);
}

void ShortSequence::ask(const SolvedBlow& blow) {
    std::optional<Scenario> asked;
    if (blow.fault.isEmpty() && !blow.marched && blow.feed && blow.feed->force) {
        asked = blow.request.scenario;
        asked->title.clear();
    }
    if (asked == m_scenario) return;
    m_scenario = std::move(asked);
    m_job.cancel();
    m_isStarted = m_isDue = false;
    m_rest.stop();
    if (!m_scenario) return;
    if (!drillingRefusals(*m_scenario, windowSettingsOf(*m_scenario)).empty()) return m_scenario.reset();
    m_march = quickMarchOf(*m_scenario);
    m_isDue = m_march.isWithinTime;
    if (m_isDue) m_rest.start();
}

void ShortSequence::follow() {
    if (m_scenario && !m_isStarted) start();
}

void ShortSequence::start() {
    m_isDue = false;
    m_isStarted = true;
    m_job.submit(
        [scenario = *m_scenario, settings = m_march.settings](const StudyFeed<DrillingResult>& feed) {
            return studyDrilling(scenario, settings, quickWants(), feed.stop);
        });
}

const DrillingResult* ShortSequence::result() const {
    const bool isThere = m_scenario && m_isStarted && m_job.state() == StudyState::finished;
    return isThere && m_job.isCurrent() ? m_job.value().get() : nullptr;
}

bool ShortSequence::isAwaited() const {
    return m_scenario && (m_isDue || (m_isStarted && m_job.state() == StudyState::running));
}

std::optional<double> ShortSequence::secondsOnRequest() const {
    if (!m_scenario || m_isStarted || m_march.isWithinTime) return std::nullopt;
    return m_march.seconds;
}

}  // namespace drillwave
