// SPDX-License-Identifier: GPL-3.0-or-later
// Studies of the pinned runs, computed beside that of the scenario.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "ui/job/study_job.h"

namespace drillwave {

/// The curve of one run, with the question that it answers, which is a value with ==.
template <class Question, class Curve>
struct RunAnswer {
    Question question;
    std::optional<Curve> curve;  ///< nothing where there is none
};

template <class Question, class Curve>
using RunAnswers = std::vector<std::shared_ptr<const RunAnswer<Question, Curve>>>;

/// Answers questions one after the other, and keeps the answers for the next time. Copies share what they
/// know; called on one thread at a time.
template <class Question, class Curve>
class RunCurveFinder {
  public:
    using Answers = RunAnswers<Question, Curve>;
    /// Nothing where there is no curve, or after a stop. Holds nothing of the window.
    using Find = std::function<std::optional<Curve>(const Question&, const std::stop_token&)>;

    explicit RunCurveFinder(Find find) : m_find(std::move(find)) {}

    /// Known answers come first. Questions that are no longer asked are forgotten.
    Answers operator()(const std::vector<Question>& questions, const StudyFeed<Answers>& feed) {
        Answers found;
        std::vector<Question> open;
        for (const Question& question : questions) {
            const auto known =
                std::ranges::find(*m_known, question, [](const auto& each) { return each->question; });
            if (known != m_known->end())
                found.push_back(*known);
            else
                open.push_back(question);
        }
        for (const Question& question : open) {
            std::optional<Curve> curve = m_find(question, feed.stop);
            if (feed.stop.stop_requested()) break;
            found.push_back(std::make_shared<const RunAnswer<Question, Curve>>(
                RunAnswer<Question, Curve>{question, std::move(curve)}));
            feed.show(found);
        }
        // A stopped study continues from there.
        *m_known = found;
        return found;
    }

  private:
    Find m_find;
    std::shared_ptr<Answers> m_known = std::make_shared<Answers>();
};

/// The curves of the runs on a page: on one thread, beside the study of the scenario, which is not kept
/// waiting by them.
template <class Question, class Curve>
class RunStudies {
  public:
    using Finder = RunCurveFinder<Question, Curve>;
    using Answers = typename Finder::Answers;

    explicit RunStudies(typename Finder::Find find) : m_study(Finder(std::move(find))) {}

    /// One for each run; runs with the same question share the answer.
    void ask(const std::vector<Question>& ofRuns) {
        std::vector<Question> questions;
        for (const Question& question : ofRuns)
            if (std::ranges::find(questions, question) == questions.end()) questions.push_back(question);
        const bool isNothing = questions.empty() && !m_study.question();
        // A failed study would fail again.
        const bool hasFailed = m_study.job().state() == StudyState::failed && m_study.question() == questions;
        if (!isNothing && !hasFailed) m_study.ask(std::move(questions));
    }
    /// Another one whenever there is news; nullptr at first.
    const std::shared_ptr<const Answers>& answers() const { return m_study.job().value(); }
    /// nullptr where there is no curve, or not yet.
    const Curve* find(const Question& question) const {
        if (!answers()) return nullptr;
        const auto found =
            std::ranges::find(*answers(), question, [](const auto& each) { return each->question; });
        return found != answers()->end() && (*found)->curve ? &*(*found)->curve : nullptr;
    }
    StudyActivity& activity() { return m_study.job(); }
    const StudyActivity& activity() const { return m_study.job(); }
    /// How many times there was something to be found.
    int started() const { return m_study.started(); }

  private:
    StudyRunner<std::vector<Question>, Answers> m_study;
};

}  // namespace drillwave
