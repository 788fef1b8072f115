// SPDX-License-Identifier: GPL-3.0-or-later
// Some consecutive rows of a sweep or a table as numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/text/csv.h"
#include "core/text/message.h"

namespace drillwave {

/// Rows that were not solved for one reason.
struct RowFailure {
    Message reason;
    std::uint64_t rows = 0;
    bool operator==(const RowFailure&) const = default;
};

/// Adds to the rows of that reason and returns its place in the list.
std::size_t addFailure(std::vector<RowFailure>& failures, const RowFailure& more);

/// Rows of the same width, first filled one after another and then read.
class RowBlock {
  public:
    /// Clears it, keeping its memory; the next row will be number `first` (from 0) of all.
    void restart(std::uint64_t first, std::size_t width);
    /// Adds a row without numbers (NaN), to be filled in before the next is added.
    std::span<double> add();
    /// Marks the row added last as not solved, with the reason.
    void fail(Message reason);
    /// Sets the text cells before the numbers, a record for each row. They must outlive the block.
    void copy(std::span<const CsvRecord> records) { m_copied = records; }

    std::uint64_t first() const { return m_first; }  ///< number of the first row of all rows, from 0
    std::size_t size() const { return m_failureOf.size(); }

    /// The numbers of row i < size() of this block, in the order of RowHeader::columns; NaN where there is
    /// none.
    std::span<const double> operator[](std::size_t i) const {
        return std::span(m_numbers).subspan(i * m_width, m_width);
    }
    /// Why row i was not solved, so that it has no outputs; empty when it was.
    const Message& reason(std::size_t i) const {
        return m_failureOf[i] == solved ? m_noReason : m_failures[m_failureOf[i]].reason;
    }
    /// The cells of row i that are copied as they are; none in a sweep.
    std::span<const std::string> copied(std::size_t i) const {
        return m_copied.empty() ? std::span<const std::string>() : m_copied[i].cells;
    }
    /// The rows that were not solved, by reason, in the order in which each occurs first.
    const std::vector<RowFailure>& failures() const { return m_failures; }

  private:
    static constexpr std::size_t solved = SIZE_MAX;

    std::uint64_t m_first = 0;
    std::size_t m_width = 0;
    std::vector<double> m_numbers;
    std::vector<std::size_t> m_failureOf;  // a place in m_failures, or `solved`
    std::vector<RowFailure> m_failures;
    Message m_noReason;
    std::span<const CsvRecord> m_copied;
};

}  // namespace drillwave
