// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/result/feed_text.h"

#include <QCoreApplication>
#include <cmath>

#include "core/blow/feed_estimate.h"
#include "core/report/feed_words.h"
#include "ui/runs/difference_text.h"
#include "ui/text/language.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {

namespace {

// While values are dragged the study would only take the time of the blows.
constexpr std::chrono::milliseconds blowRest{100};

// The force that the blow itself requires.
double requiredBy(const SolvedBlow& blow) {
    return blow.feed->need(ThrustCase::scenario).thrust;
}

// Returns the unit that suits the required feed, so that all can be compared at a glance.
ShownUnit unitOf(const SolvedBlow& blow) {
    const double installed = blow.scenario.drill.thrust.value_or(0);
    ShownUnit unit = blow.units.of(UnitKind::force, blow.feed ? requiredBy(blow) : installed);
    unit.prefixes.reset();
    return unit;
}

QString forceText(double force, const SolvedBlow& blow) {
    return quantityText(force, unitOf(blow), QLocale());
}

}  // namespace

WorstNeed::WorstNeed(QObject* parent) : QObject(parent) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(blowRest);
    connect(&m_rest, &QTimer::timeout, this, &WorstNeed::run);
    connect(&m_job, &StudyActivity::changed, this, &WorstNeed::changed);
}

void WorstNeed::ask(const SolvedBlow& blow) {
    std::optional<Scenario> asked;
    if (blow.fault.isEmpty() && blow.feed && blow.feed->gapsHavePeriod) {
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

QString thrustNeededText(const SolvedBlow& blow) {
    return blow.feed ? forceText(requiredBy(blow), blow) : QString();
}

QString returnInTimeText(const SolvedBlow& blow) {
    return blow.feed ? forceText(blow.feed->need(ThrustCase::scenario).thrustUndamped, blow) : QString();
}

QString worstNeedText(const WorstNeed& worst, const SolvedBlow& blow) {
    if (!blow.feed) return {};
    const QString soon = QStringLiteral("…");
    const std::optional<double> thrust = worst.thrust();
    if (!thrust) return worst.isCurrent() ? QString() : soon;
    const QString text = forceText(*thrust, blow);
    return worst.isCurrent() ? text : QStringLiteral("(%1) %2").arg(text, soon);
}

namespace {

std::optional<double> worstMargin(const WorstNeed& worst, const SolvedBlow& blow) {
    const std::optional<double> need = worst.thrust();
    if (!worst.isCurrent() || !need || !blow.feed || !blow.feed->force) return std::nullopt;
    return *blow.feed->effective() - *need;
}

}  // namespace

bool isShortOfWorst(const WorstNeed& worst, const SolvedBlow& blow) {
    const std::optional<double> margin = worstMargin(worst, blow);
    return margin && *margin < 0;
}

QString worstMarginText(const WorstNeed& worst, const SolvedBlow& blow) {
    if (!blow.feed || !blow.feed->force) return {};
    if (!worst.isCurrent()) return QStringLiteral("…");
    const std::optional<double> margin = worstMargin(worst, blow);
    if (!margin) return {};
    const QString size = forceText(std::abs(*margin), blow);
    const QString share = numberText(std::abs(std::round(100 * *margin / *worst.thrust())), 4, QLocale());
    if (*margin < 0)
        return QCoreApplication::translate("drillwave::FeedText", "⚠ short by %1 (−%2 %)").arg(size, share);
    return QCoreApplication::translate("drillwave::FeedText", "✓ met, %1 (%2 %) to spare").arg(size, share);
}

QString thrustInstalledText(const SolvedBlow& blow) {
    const std::optional<FeedForce> feed = feedForceOf(blow.scenario);
    if (!feed) return {};
    const QString thrust = forceText(feed->thrust, blow);
    if (!feed->weight) return thrust;
    return QCoreApplication::translate("drillwave::FeedText", "%1, effective %2")
        .arg(thrust, forceText(feed->effective(), blow));
}

std::optional<double> thrustMargin(const SolvedBlow& blow) {
    if (!blow.feed || !blow.feed->force) return std::nullopt;
    return *blow.feed->effective() - requiredBy(blow);
}

QString thrustMarginText(const SolvedBlow& blow) {
    const std::optional<double> margin = thrustMargin(blow);
    if (!margin) return {};
    const QString share = numberText(std::round(100 * *margin / requiredBy(blow)), 4, QLocale());
    return forceText(*margin, blow) + QStringLiteral(" (%1%2 %)").arg(*margin > 0 ? "+" : "", share);
}

QString marginChangeText(double margin, double reference, const SolvedBlow& blow) {
    constexpr double rounding = 1e-12;  // of the thrust: a smaller difference is none
    const ShownUnit unit = unitOf(blow);
    const double change = margin - reference;
    const bool isNone = blow.feed && std::abs(change) <= rounding * requiredBy(blow);
    return signedText(isNone ? 0 : change * unit.factor, 3) + QChar(QChar::Nbsp) + unit.unit;
}

FeedEstimateOnShow estimateOnShow(const WorstNeed& worst, const SolvedBlow& blow) {
    if (!blow.fault.isEmpty()) return {};
    const std::optional<FeedEstimate> ofAllGaps = worst.isCurrent() ? worst.estimate() : std::nullopt;
    return {ofAllGaps ? ofAllGaps : blow.feed, worst.isAwaited()};
}

QString requiredText(const FeedEstimateOnShow& shown, const SolvedBlow& blow) {
    if (!blow.fault.isEmpty()) return {};
    return translated(requiredFeedMessage(blow.scenario, shown.estimate, styleOf(blow.request))) +
           (shown.isAwaited ? QStringLiteral(" …") : QString());
}

}  // namespace drillwave
