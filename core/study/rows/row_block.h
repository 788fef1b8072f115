// SPDX-License-Identifier: GPL-3.0-or-later
// Block of consecutive result rows of a sweep or a table, as numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/text/csv.h"
#include "core/text/message.h"

namespace drillwave {

/// Number of rows that were not solved for the same reason.
struct RowFailure {
    Message reason;
    std::uint64_t rows = 0;
    bool operator==(const RowFailure&) const = default;
};

/// Adds `more.rows` to the entry of `failures` with the same reason, or appends a new entry. Returns the
/// index of the entry.
std::size_t addFailure(std::vector<RowFailure>& failures, const RowFailure& more);

/// Block of consecutive result rows of equal width. Rows are first filled one after another and then read.
class RowBlock {
  public:
    /// Removes all rows but keeps the memory for the next ones. `first` is the index (from 0) of the next row
    /// among all rows of the run, `width` the number of values in a row.
    void restart(std::uint64_t first, std::size_t width);
    /// Adds a row of NaN values and returns it. It must be filled before the next row is added.
    std::span<double> add();
    /// Marks the last row added as not solved, with the reason.
    void fail(Message reason);
    /// Sets the text cells that precede the numbers, one record for each row. The records must outlive the
    /// block.
    void copy(std::span<const CsvRecord> records) { m_copied = records; }

    /// Returns the index of the first row of this block among all rows, from 0.
    std::uint64_t first() const { return m_first; }
    std::size_t size() const { return m_failureOf.size(); }

    /// Returns the values of row i < size() of this block, in the order of RowHeader::columns; NaN if there
    /// is no value.
    std::span<const double> operator[](std::size_t i) const {
        return std::span(m_numbers).subspan(i * m_width, m_width);
    }
    /// Returns why row i was not solved and has no outputs; empty if it was solved.
    const Message& reason(std::size_t i) const {
        return m_failureOf[i] == solved ? m_noReason : m_failures[m_failureOf[i]].reason;
    }
    /// Returns the text cells of row i that are copied unchanged; empty for a sweep.
    std::span<const std::string> copied(std::size_t i) const {
        return m_copied.empty() ? std::span<const std::string>() : m_copied[i].cells;
    }
    /// Returns how many rows were not solved for each reason, in the order in which the reasons first
    /// occurred.
    const std::vector<RowFailure>& failures() const { return m_failures; }

  private:
    static constexpr std::size_t solved = SIZE_MAX;

    std::uint64_t m_first = 0;
    std::size_t m_width = 0;
    std::vector<double> m_numbers;
    std::vector<std::size_t> m_failureOf;  // index into m_failures, or `solved`
    std::vector<RowFailure> m_failures;
    Message m_noReason;
    std::span<const CsvRecord> m_copied;
};

}  // namespace drillwave
