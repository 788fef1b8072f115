// SPDX-License-Identifier: GPL-3.0-or-later
// Pinned runs as columns of numbers: changed parameters first, then results.
#pragma once

#include <QByteArray>
#include <QLocale>
#include <QStringList>
#include <optional>
#include <vector>

#include "ui/job/solved_blow.h"

namespace drillwave {

class UnitChoice;

/// Column of the comparison: one run or the present result.
struct CompareColumn {
    QString title;                               ///< title, such as "now" or "A  k 300 MN/m"
    const Scenario* scenario;                    ///< scenario of the column; never nullptr
    const SolvedBlow* blow;                      ///< blow of the column; nullptr if there is none
    std::optional<FeedEstimate> ofAllGaps = {};  ///< feed force required at every gap; empty if not studied
};

/// Row of the table that compares runs: one quantity with its values in all columns, in the units shown.
struct CompareRow {
    enum class Kind { heading, parameter, result } kind = Kind::result;
    QString name;
    QString unit;                                ///< unit of the numbers; empty for dimensionless numbers
    std::vector<std::optional<double>> numbers;  ///< number of each column; empty if the column has none
    QStringList words;                           ///< words of each column, instead of numbers
    /// For each column, whether its number has another unit than that of the first solved column. Multiples
    /// of a scale of a uniform rod cannot be compared with those of a drill string.
    std::vector<bool> hasOtherUnit = {};
    bool isSigned = false;  ///< whether numbers are printed with their sign, as margins are

    bool hasNumbers() const { return !numbers.empty(); }
    /// Returns the text of this row in one column: its words, or its number with five digits; empty if it has
    /// neither.
    QString text(std::size_t column, const QLocale& locale) const;
    /// Returns the number of a column minus that of the reference column. Nothing if a number is missing or
    /// their units differ.
    std::optional<double> difference(std::size_t column, std::size_t reference) const;
    /// Returns difference() divided by the magnitude of the reference column's number; nothing if it does not
    /// exist.
    std::optional<double> relative(std::size_t column, std::size_t reference) const;
};

/// Table of runs as columns, with headings, changed parameters and results as rows.
struct CompareTable {
    QStringList titles;         ///< titles of the columns
    std::size_t reference = 0;  ///< index of the column that the others are compared with
    std::vector<CompareRow> rows;
};

/// Returns the table of the columns: parameters that differ, and all results that at least one column has.
/// Estimates of numerical errors are left out; margins of the feed force are added. `units` and `chosen` are
/// the units of results, with prefixes that suit the first solved column. `fields` holds the units of
/// parameters.
CompareTable compareTable(const std::vector<CompareColumn>& columns, std::size_t reference, UnitSystem units,
                          const ChosenUnits& chosen, const UnitChoice& fields);

/// Returns the table with all digits; empty without columns. Each line holds name, unit and numbers, then the
/// difference of each column from the reference, absolute and in percent. The separator ',' gives CSV (RFC
/// 4180). A tab gives text that can be pasted into a spreadsheet.
QByteArray compareText(const CompareTable& table, char separator);

}  // namespace drillwave
