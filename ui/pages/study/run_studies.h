// SPDX-License-Identifier: GPL-3.0-or-later
// Studies of the pinned runs (results kept for comparison), computed in parallel with the study of the
// scenario.
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

/// Curve of one pinned run (a result kept for comparison), with the question (input of the computation) that
/// it answers.
template <class Question, class Curve>
struct RunAnswer {
    Question question;
    std::optional<Curve> curve;  ///< the curve; empty if the run has none
};

template <class Question, class Curve>
using RunAnswers = std::vector<std::shared_ptr<const RunAnswer<Question, Curve>>>;

/// Function object that answers questions one after another and keeps the answers for the next call. Copies
/// share the kept answers. Must not be called on two threads at the same time.
template <class Question, class Curve>
class RunCurveFinder {
  public:
    using Answers = RunAnswers<Question, Curve>;
    /// Function that computes a curve. Returns nothing if there is no curve or after a stop. It is called
    /// outside the window's thread and must not use the window.
    using Find = std::function<std::optional<Curve>(const Question&, const std::stop_token&)>;

    explicit RunCurveFinder(Find find) : m_find(std::move(find)) {}

    /// Returns the answers to the questions; some are missing after a stop. Answers kept from earlier calls
    /// come first, then new ones in the order of the questions. `feed` shows each new one as soon as it is
    /// found. Kept answers to other questions are dropped.
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
        // After a stop, the next call continues from these answers.
        *m_known = found;
        return found;
    }

  private:
    Find m_find;
    std::shared_ptr<Answers> m_known = std::make_shared<Answers>();
};

/// Curves of the pinned runs (results kept for comparison) on a page. They are computed on their own thread,
/// so that the study of the scenario does not wait for them.
template <class Question, class Curve>
class RunStudies {
  public:
    using Finder = RunCurveFinder<Question, Curve>;
    using Answers = typename Finder::Answers;

    explicit RunStudies(typename Finder::Find find) : m_study(Finder(std::move(find))) {}

    /// Starts the computation of a curve for each pinned run, unless it is known already. `ofRuns` are the
    /// questions (inputs of the computation) of the runs. Equal questions share one curve.
    void ask(const std::vector<Question>& ofRuns) {
        std::vector<Question> questions;
        for (const Question& question : ofRuns)
            if (std::ranges::find(questions, question) == questions.end()) questions.push_back(question);
        const bool isNothing = questions.empty() && !m_study.question();
        // A failed study would fail again.
        const bool hasFailed = m_study.job().state() == StudyState::failed && m_study.question() == questions;
        if (!isNothing && !hasFailed) m_study.ask(std::move(questions));
    }
    /// Returns the latest answers, as a new object after each change; nullptr at first.
    const std::shared_ptr<const Answers>& answers() const { return m_study.job().value(); }
    /// Returns the curve for a question; nullptr if there is none, or none yet.
    const Curve* find(const Question& question) const {
        if (!answers()) return nullptr;
        const auto found =
            std::ranges::find(*answers(), question, [](const auto& each) { return each->question; });
        return found != answers()->end() && (*found)->curve ? &*(*found)->curve : nullptr;
    }
    StudyActivity& activity() { return m_study.job(); }
    const StudyActivity& activity() const { return m_study.job(); }
    /// Returns how often a computation was started, for tests.
    int started() const { return m_study.started(); }

  private:
    StudyRunner<std::vector<Question>, Answers> m_study;
};

}  // namespace drillwave
