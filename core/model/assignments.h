// SPDX-License-Identifier: GPL-3.0-or-later
// What one scenario is given by keys: the order in which to set them, and which of them contradict.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace drillwave {

/// Whether setting one key undoes what setting the other did: the same key, a group and the physical
/// parameter it moves, mean force and impulse, area and diameters. A name and a place of sections are no
/// rivals: what is set at a place goes last.
bool areRivals(std::string_view a, std::string_view b);

/// Keys that are set together, numbered as they were added. What each is set to stays with who asks: a word
/// of the command line, an axis of a sweep, a cell of a table.
class Assignments {
  public:
    Assignments() = default;
    explicit Assignments(const std::vector<std::string_view>& keys);

    /// The next number is that of this key, known or not.
    void add(std::string_view key);
    /// The next number sets nothing.
    void skip();

    /// The numbers of the keys in the order in which a scenario takes them: the shape, which decides what
    /// applies (and with it whatever is not in the table of parameters); physical parameters in the order of
    /// the table; of a string the repeat, then sections by name, then by place; the groups, which move
    /// physical parameters.
    const std::vector<std::size_t>& order() const { return m_order; }

    /// Whether one of the two would undo the other.
    bool contradict(std::size_t a, std::size_t b) const;

    /// Whether the hammer blow depends on the key: it has its own parameters and, for a piston, the rod's;
    /// that of a string all of hammer and string.
    bool movesPulse(std::size_t number) const;
    /// Whether it does on any of the keys.
    bool movePulse() const;

  private:
    std::vector<std::optional<std::string_view>> m_keys;  // none: sets nothing
    std::vector<std::size_t> m_order;
};

}  // namespace drillwave
