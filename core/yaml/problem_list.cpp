// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/problem_list.h"

#include <algorithm>
#include <tuple>

#include "core/text/decimal_text.h"

namespace drillwave {
namespace {

constexpr std::size_t maximumProblems = 100;

}  // namespace

void ProblemList::reportValue(std::size_t offset, std::string_view key, std::string_view value,
                              const Message& reason) {
    reportKey(offset, key, "");
    if (m_leftOut == 0)
        m_problems.back().text = {"%1 (%2)", {std::string(key) + " = " + shortened(trimmed(value)), reason}};
}

void ProblemList::reportKey(std::size_t offset, std::string_view key, const Message& reason) {
    // Finding the place costs a walk through the text: not for problems nobody will see.
    const bool full = m_problems.size() >= maximumProblems;
    const TextPosition at = full ? TextPosition{} : position(offset);
    report({std::string(key), {"%1 (%2)", {shortened(key), reason}}, at.line, at.column});
}

void ProblemList::reportAt(std::size_t offset, InputProblem problem) {
    const TextPosition at = position(offset);
    problem.line = at.line;
    problem.column = at.column;
    report(std::move(problem));
}

void ProblemList::report(InputProblem problem) {
    m_keys.insert(problem.key);
    if (m_problems.size() < maximumProblems)
        m_problems.push_back(std::move(problem));
    else
        ++m_leftOut;
}

std::vector<InputProblem> ProblemList::take() {
    const auto place = [](const InputProblem& p) { return std::tuple(!p.source.empty(), p.line, p.column); };
    std::ranges::stable_sort(m_problems, {}, place);
    if (m_leftOut > 0) {
        const InputProblem& last = m_problems.back();
        m_problems.push_back({"",
                              {translatable("and %1 more problems"), {std::to_string(m_leftOut)}},
                              last.line,
                              last.column});
    }
    return std::move(m_problems);
}

}  // namespace drillwave
