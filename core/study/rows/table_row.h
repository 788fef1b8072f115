// SPDX-License-Identifier: GPL-3.0-or-later
// Converts one row of a table of cases into a scenario.
#pragma once

#include <string>
#include <vector>

#include "core/model/scenario.h"
#include "core/study/rows/table_header.h"
#include "core/text/csv.h"

namespace drillwave {

/// Returns the message that a row has `cells` cells although the table has `columns` columns.
Message cellCountProblem(std::size_t cells, std::size_t columns);

/// Converter from a row of a table of cases to a scenario: sets the cells of the row in a copy of the base
/// scenario. Each thread needs its own object.
class TableRowAssigner {
  public:
    /// Stores references to all arguments, which must outlive this object. `source` is the name of the file,
    /// for messages.
    TableRowAssigner(const Scenario& base, const std::string& source, const TableHeader& header);

    /// Returns the scenario that the last call of assign() has set.
    const Scenario& scenario() const { return m_scenario; }

    /// Sets the cells of a row on top of the base scenario. Returns the problems with their positions, such
    /// as "cases.csv:7:3: bit_rock.gamma = 1.3 (…)". Empty if scenario() is then valid. `line` is the line
    /// number of the row, from 1.
    std::vector<Message> assign(const CsvRecord& row, int line);

  private:
    std::vector<Message> assignCells(const CsvRecord& row, int line);
    Message assignCell(const CaseColumn& column, const std::string& cell);
    Message rivalText(const RivalPair& pair) const;

    std::string place(int line) const { return m_source + ":" + std::to_string(line); }

    const Scenario& m_base;
    const std::string& m_source;
    const TableHeader& m_header;
    Assignments m_assignments;
    Scenario m_scenario;
};

}  // namespace drillwave
