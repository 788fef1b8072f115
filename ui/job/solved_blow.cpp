// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/job/solved_blow.h"

#include <exception>

#include "core/model/validation.h"
#include "core/study/drilling/marched_blow.h"
#include "ui/text/language.h"
#include "ui/text/shown_text.h"

namespace drillwave {

namespace {

QString whyUnsolved(const Blow& blow) {
    if (blow.isSolved()) return {};
    if (blow.impact.reason.isEmpty()) return QStringLiteral("The blow could not be solved.");
    return translated(blow.impact.reason);
}

void preparePages(SolvedBlow& blow) {
    for (const PreparePage& prepare : blow.request.pages)
        if (prepare) blow.pages.push_back(prepare(blow));
}

// Drops the functions of the pages, which may hold lists of runs, so that they do not outlive the job.
void dropMeans(SolveRequest& request) {
    request.pages.clear();
    request.stop = {};
}

/// Returns one of many blows, with the pages of a request.
SolvedBlowPtr marchedAnswer(const SolveRequest& request, const SolvedBlow* before) {
    auto blow = std::make_shared<SolvedBlow>();
    const bool isKnown = before && before->marchedBlow && before->marchedBlow->isSolved() &&
                         before->request.marched == request.marched &&
                         before->request.scenario == request.scenario;
    static_cast<Blow&>(*blow) = isKnown ? static_cast<const Blow&>(*before->marchedBlow)
                                        : marchedBlow(request.scenario, request.marched->settings,
                                                      request.marched->number, request.stop);
    blow->request = request;
    blow->request.scenario = blow->scenario;
    blow->units = shownUnits(request.units, blow->scales, request.chosenUnits);
    blow->fault = whyUnsolved(*blow);
    if (blow->isSolved()) preparePages(*blow);
    dropMeans(blow->request);
    return blow;
}

/// Completes a request with the blow returned by `make`.
template <class Make>
SolvedBlowPtr answerWith(const SolveRequest& request, const SolvedBlow* before, const Make& make) noexcept {
    auto blow = std::make_shared<SolvedBlow>();
    try {
        blow->request = request;
        const std::vector<InputProblem> problems = validate(request.scenario);
        if (!problems.empty()) return failedBlow(request, translated(problems.front().text));
        static_cast<Blow&>(*blow) = make();
        blow->units = shownUnits(request.units, blow->scales, request.chosenUnits);
        blow->fault = whyUnsolved(*blow);
        if (request.marched)
            blow->marchedBlow = marchedAnswer(request, before);
        else if (blow->isSolved())
            preparePages(*blow);
        dropMeans(blow->request);
    } catch (const std::exception& error) {
        return failedBlow(request, QString::fromUtf8(error.what()));
    }
    return blow;
}

}  // namespace

LocalStyle styleOf(const SolveRequest& request) {
    return {QLocale(), request.physicalUnits, request.chosenUnits};
}

SolvedBlowPtr solveBlow(const SolveRequest& request, MethodSolver& solver,
                        const SolvedBlow* before) noexcept {
    return answerWith(request, before, [&] {
        return solveBlow(request.scenario, {}, Detail::histories, request.stop, Stresses::wanted, solver,
                         request.quick ? NetworkAccuracy::quick : NetworkAccuracy::sure);
    });
}

bool answersAgain(const SolvedBlow& before, const SolveRequest& request) {
    return before.isOfString() && before.isSolved() && before.scenario == request.scenario &&
           (request.quick || !before.request.quick);
}

SolvedBlowPtr answerAgain(const SolvedBlow& before, const SolveRequest& request) noexcept {
    SolveRequest asked = request;
    asked.quick = before.request.quick;
    return answerWith(asked, &before, [&] { return static_cast<const Blow&>(before); });
}

SolvedBlowPtr failedBlow(const SolveRequest& request, const QString& problem) {
    auto blow = std::make_shared<SolvedBlow>();
    blow->request = request;
    dropMeans(blow->request);
    blow->fault = problem;
    blow->units.system = request.units;
    blow->units.chosen = request.chosenUnits;
    return blow;
}

}  // namespace drillwave
