// SPDX-License-Identifier: GPL-3.0-or-later
// A parameter to keep: of axes, families, table columns and edits. What refers to one only while it is used
// takes a const Parameter&.
#pragma once

#include <cstddef>
#include <memory>

namespace drillwave {

struct Parameter;

/// A row of the table of parameters, the repeat of a string, or a number of a section, which lives as long as
/// something keeps it; or none. A value: copies are cheap, and two are equal that have the same key.
class KeptParameter {
  public:
    KeptParameter() = default;
    KeptParameter(std::nullptr_t) {}
    /// The same parameter, whoever keeps it now.
    KeptParameter(const Parameter& parameter);
    /// One that nobody else keeps.
    explicit KeptParameter(std::shared_ptr<const Parameter> parameter);

    explicit operator bool() const { return m_parameter != nullptr; }
    /// Requires that there is one. But for rows of the table it lives no longer than it is kept.
    const Parameter& operator*() const;
    const Parameter* operator->() const { return &**this; }

    friend bool operator==(const KeptParameter& one, const KeptParameter& other);

  private:
    std::shared_ptr<const Parameter> m_parameter;  // without an owner where it lives as long as the program
};

}  // namespace drillwave
