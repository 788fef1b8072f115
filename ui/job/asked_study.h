// SPDX-License-Identifier: GPL-3.0-or-later
// A study that is run for a question, and once only for the same one.
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "ui/job/study_job.h"

namespace drillwave {

/// Runs `study` of a question away from the window's thread. Question is a value with ==.
template <class Question, class Value>
class AskedStudy {
  public:
    /// Called on the job's thread: holds nothing of the window.
    using Study = std::function<Value(const Question&, const StudyFeed<Value>&)>;

    explicit AskedStudy(Study study) : m_study(std::move(study)) {}

    /// Runs the study unless it runs for the same question, or has been finished for it. Whether it was
    /// started.
    bool ask(Question question) {
        const bool answered = m_job.state() == StudyState::running || m_job.state() == StudyState::finished;
        if (answered && m_question == question) return false;
        m_question = question;
        ++m_started;
        m_job.submit([study = m_study, question = std::move(question)](const StudyFeed<Value>& feed) {
            return study(question, feed);
        });
        return true;
    }

    /// The question asked last; nothing before the first.
    const std::optional<Question>& question() const { return m_question; }
    StudyJob<Value>& job() { return m_job; }
    const StudyJob<Value>& job() const { return m_job; }
    /// The result, or what there is so far of the question asked last or of an earlier one; nullptr at first.
    const Value* value() const { return m_job.value().get(); }
    /// How many studies were started.
    int started() const { return m_started; }

  private:
    Study m_study;
    std::optional<Question> m_question;
    int m_started = 0;
    StudyJob<Value> m_job;
};

}  // namespace drillwave
