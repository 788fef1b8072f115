// SPDX-License-Identifier: GPL-3.0-or-later
// Problems of a scenario text, collected with their places.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/validation.h"
#include "core/text/text_input.h"

namespace drillwave {

/// Collects the problems of one text, up to a limit that a person would still read, in the order of the text.
class ProblemList {
  public:
    explicit ProblemList(std::string_view text) : m_text(text) {}

    /// "key = value (reason)" at a byte of the text.
    void reportValue(std::size_t offset, std::string_view key, std::string_view value, const Message& reason);
    /// "key (reason)" at a byte of the text.
    void reportKey(std::size_t offset, std::string_view key, const Message& reason);
    /// A problem as it is, its place being known already.
    void report(InputProblem problem);
    /// A problem of what was read, at a byte of the text.
    void reportAt(std::size_t offset, InputProblem problem);

    bool empty() const { return m_problems.empty(); }
    /// Line and column of a byte of the text.
    TextPosition position(std::size_t offset) const { return positionOf(m_text, offset); }
    /// Whether something was reported about that key.
    bool concerns(std::string_view key) const { return m_keys.contains(std::string(key)); }
    /// The problems by line and column; the last one tells how many were left out.
    std::vector<InputProblem> take();

  private:
    std::string_view m_text;
    std::vector<InputProblem> m_problems;
    std::set<std::string> m_keys;
    std::size_t m_leftOut = 0;
};

}  // namespace drillwave
