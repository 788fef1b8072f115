// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/accuracy/proof_study.h"

#include <QCoreApplication>
#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace drillwave {
namespace {

ProofAnswer proveAccuracy(const ProofQuestion& question, const StudyFeed<ProofAnswer>& feed) {
    constexpr std::size_t parts = 1000;  // of the work
    const auto answer = [&](const Accuracy& accuracy) {
        return ProofAnswer{question, std::make_shared<const Accuracy>(accuracy), nullptr};
    };
    feed.show(answer({}));
    Accuracy accuracy = measureAccuracy(
        question.scenario, latticeLadder(), feed.stop,
        [&](double done) { feed.tell({.done = static_cast<std::size_t>(done * parts), .wanted = parts}); },
        [&](const Accuracy& soFar) { feed.show(answer(soFar)); });
    if (!feed.stop.stop_requested() && accuracy.exact.outcome != Outcome::rebounded)
        throw std::runtime_error(QCoreApplication::translate("drillwave::ProofStudy", "Not solved: %1")
                                     .arg(QString::fromStdString(accuracy.exact.reason))
                                     .toStdString());
    return answer(accuracy);
}

ProofAnswer proveStability(const ProofQuestion& question, const StudyFeed<ProofAnswer>& feed) {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds between{500};  // of what is shown: all rows are copied
    const auto answer = [&](const StabilityReport& report) {
        return ProofAnswer{question, nullptr, std::make_shared<const StabilityReport>(report)};
    };
    feed.show(answer({}));
    const std::vector<StabilityCase> cases = stabilityCases();
    const int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    auto last = Clock::now();
    return answer(checkStability(cases, jobs, feed.stop, [&](const StabilityReport& soFar) {
        feed.tell({.done = soFar.rows.size(), .wanted = cases.size()});
        if (Clock::now() - last < between) return;
        last = Clock::now();
        feed.show(answer(soFar));
    }));
}

}  // namespace

ProofAnswer prove(const ProofQuestion& question, const StudyFeed<ProofAnswer>& feed) {
    return question.proof == Proof::accuracy ? proveAccuracy(question, feed) : proveStability(question, feed);
}

}  // namespace drillwave
