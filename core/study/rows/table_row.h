// SPDX-License-Identifier: GPL-3.0-or-later
// One row of a table of cases, from cells to a scenario.
#pragma once

#include <string>
#include <vector>

#include "core/model/scenario.h"
#include "core/study/rows/table_header.h"
#include "core/text/csv.h"

namespace drillwave {

/// Returns the message on a row whose number of cells differs from the number of columns.
Message cellCountProblem(std::size_t cells, std::size_t columns);

/// Sets the cells of one row after another on top of a scenario. One object per thread.
class TableRowAssigner {
  public:
    /// `source` names the file, for messages; all three must outlive this.
    TableRowAssigner(const Scenario& base, const std::string& source, const TableHeader& header);

    /// Returns the scenario of the row last assigned.
    const Scenario& scenario() const { return m_scenario; }

    /// Assigns a row; returns its problems on that line (from 1), each with its place, "cases.csv:7:3:
    /// bit_rock.gamma = 1.3 (…)"; empty if scenario() is its valid scenario.
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
