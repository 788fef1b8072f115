// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/accuracy/proof_study.h"

#include <QCoreApplication>
#include <chrono>
#include <stdexcept>

#include "core/model/blow_traits.h"
#include "core/numeric/available_threads.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr std::size_t parts = 1000;  // of the work

StudyProgress partOf(double done) {
    return {.done = static_cast<std::size_t>(done * parts), .wanted = parts};
}

std::runtime_error notSolved(const Message& reason) {
    return std::runtime_error(QCoreApplication::translate("drillwave::ProofStudy", "Not solved: %1")
                                  .arg(translated(reason))
                                  .toStdString());
}

ProofAnswer proveStringAccuracy(const ProofQuestion& question, const StudyFeed<ProofAnswer>& feed) {
    const auto answer = [&](const StringAccuracy& accuracy) {
        return ProofAnswer{question, nullptr, std::make_shared<const StringAccuracy>(accuracy), nullptr};
    };
    feed.show(answer({}));
    const StringAccuracy accuracy =
        measureStringAccuracy(question.scenario, feed.stop, [&](const StringAccuracy& soFar, double done) {
            feed.tell(partOf(done));
            feed.show(answer(soFar));
        });
    if (!accuracy.isStopped && !accuracy.reason.isEmpty()) throw notSolved(accuracy.reason);
    return answer(accuracy);
}

ProofAnswer proveAccuracy(const ProofQuestion& question, const StudyFeed<ProofAnswer>& feed) {
    const auto answer = [&](const Accuracy& accuracy) {
        return ProofAnswer{question, std::make_shared<const Accuracy>(accuracy), nullptr, nullptr};
    };
    feed.show(answer({}));
    Accuracy accuracy = measureAccuracy(
        question.scenario, latticeLadder(), feed.stop, [&](double done) { feed.tell(partOf(done)); },
        [&](const Accuracy& soFar) { feed.show(answer(soFar)); });
    if (!feed.stop.stop_requested() && !accuracy.exact.isSolved()) throw notSolved(accuracy.exact.reason);
    return answer(accuracy);
}

ProofAnswer proveStability(const ProofQuestion& question, const StudyFeed<ProofAnswer>& feed) {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds between{500};  // of what is shown: all rows are copied
    const auto answer = [&](const StabilityReport& report) {
        return ProofAnswer{question, nullptr, nullptr, std::make_shared<const StabilityReport>(report)};
    };
    feed.show(answer({}));
    const std::vector<StabilityCase> cases = stabilityCases();
    auto last = Clock::now();
    return answer(checkStability(cases, availableThreads(), feed.stop, [&](const StabilityReport& soFar) {
        feed.tell({.done = soFar.rows.size(), .wanted = cases.size()});
        if (Clock::now() - last < between) return;
        last = Clock::now();
        feed.show(answer(soFar));
    }));
}

}  // namespace

ProofAnswer prove(const ProofQuestion& question, const StudyFeed<ProofAnswer>& feed) {
    if (question.proof == Proof::stability) return proveStability(question, feed);
    return isFollowedByEvents(question.scenario) ? proveAccuracy(question, feed)
                                                 : proveStringAccuracy(question, feed);
}

}  // namespace drillwave
