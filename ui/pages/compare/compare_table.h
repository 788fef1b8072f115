// SPDX-License-Identifier: GPL-3.0-or-later
// Runs side by side as numbers: changed parameters first, then results.
#pragma once

#include <QByteArray>
#include <QLocale>
#include <QStringList>
#include <optional>
#include <vector>

#include "ui/job/solved_blow.h"

namespace drillwave {

class UnitChoice;

/// A column of the table.
struct CompareColumn {
    QString title;                               ///< "now", "A  k 300 MN/m"
    const Scenario* scenario;                    ///< not nullptr
    const SolvedBlow* blow;                      ///< nullptr where there is none
    std::optional<FeedEstimate> ofAllGaps = {};  ///< what all gaps require, where that was studied
};

/// One quantity of all columns, in the units on show.
struct CompareRow {
    enum class Kind { heading, parameter, result } kind = Kind::result;
    QString name;
    QString unit;                                ///< empty for plain numbers
    std::vector<std::optional<double>> numbers;  ///< one for each column; none where it has none
    QStringList words;                           ///< instead of numbers: shapes of the blow
    /// Whether each number has another unit than the first: multiples of a scale of a rod cannot be compared
    /// with those of a string.
    std::vector<bool> hasOtherUnit = {};
    bool isSigned = false;  ///< a margin, which is printed with its sign

    bool hasNumbers() const { return !numbers.empty(); }
    /// The word, or the number to five digits; empty where the column has none.
    QString text(std::size_t column, const QLocale& locale) const;
    /// number − that of the reference; nothing where one of them is missing.
    std::optional<double> difference(std::size_t column, std::size_t reference) const;
    /// Returns the difference as a share of the reference.
    std::optional<double> relative(std::size_t column, std::size_t reference) const;
};

struct CompareTable {
    QStringList titles;         ///< of the columns
    std::size_t reference = 0;  ///< the column that the others are compared with
    std::vector<CompareRow> rows;
};

/// Returns all results that at least one of the columns has, without numerical errors, and margins of the
/// thrust. `units` and `chosen` are those on show; their prefixes follow the first column that is solved.
/// `fields` has the units of parameters.
CompareTable compareTable(const std::vector<CompareColumn>& columns, std::size_t reference, UnitSystem units,
                          const ChosenUnits& chosen, const UnitChoice& fields);

/// The table with all digits: name, unit, the columns, and for each but the reference its difference and its
/// relative difference in percent; empty without columns. RFC 4180 with ',', or with a tab for spreadsheets.
QByteArray compareText(const CompareTable& table, char separator);

}  // namespace drillwave
