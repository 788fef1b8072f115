// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rows/table.h"

#include <algorithm>
#include <optional>

#include "core/study/rows/case_solver.h"
#include "core/study/rows/table_header.h"
#include "core/study/rows/table_row.h"
#include "core/text/csv.h"

namespace drillwave {

namespace {

/// Limits of a chunk: rows to hand over at once, and bytes so that long cells cost no more memory.
constexpr std::size_t chunkRows = 256;
constexpr std::size_t chunkBytes = 1 << 18;
constexpr std::size_t maximumProblems = 20;

struct Chunk {
    std::vector<TableRow> rows;
    std::size_t used = 0;  // rows of this chunk; the rest are kept for their memory
    std::string text;
    std::vector<RowFailure> failures;
    std::vector<std::string> problems;
};

/// Reads rows first … last − 1, numbered from the row below the header.
class RowReader {
  public:
    RowReader(std::istream& cases, RowRange range) : m_reader(cases), m_range(range) {}

    bool header(CsvRecord& record) { return m_reader.next(record); }
    int line() const { return m_reader.line(); }

    bool fill(Chunk& chunk) {
        chunk.used = 0;
        std::size_t bytes = 0;
        while (m_next < m_range.end && chunk.used < chunkRows && bytes < chunkBytes) {
            if (chunk.used == chunk.rows.size()) chunk.rows.emplace_back();
            TableRow& row = chunk.rows[chunk.used];
            if (!m_reader.next(row.record)) break;
            row.line = m_reader.line();
            if (m_next++ < m_range.begin) continue;
            for (const std::string& cell : row.record.cells) bytes += cell.size() + sizeof(std::string);
            ++chunk.used;
        }
        return chunk.used > 0;
    }

  private:
    CsvReader m_reader;
    RowRange m_range;
    std::uint64_t m_next = 0;
};

/// Solves rows into text. One for each thread.
class RowMaker {
  public:
    RowMaker(const Table& table, const TableHeader& header)
        : m_assigner(table.base, table.source, header),
          m_outputs(table.columns.size()),
          m_movesPulse(header.assignments().movePulse()),
          m_solver(table.columns, table.method, table.workLimit) {
        m_solver.setPulse(table.base);
    }

    void operator()(Chunk& chunk, std::stop_token stop) {
        chunk.text.clear();
        chunk.failures.clear();
        for (std::size_t i = 0; i < chunk.used; ++i) {
            if (stop.stop_requested()) return;
            const std::string reason = appendRow(chunk.rows[i], chunk.text, stop);
            if (!reason.empty()) addFailure(chunk.failures, {reason, 1});
        }
    }

  private:
    /// Returns why the row could not be solved.
    std::string appendRow(const TableRow& row, std::string& text, const std::stop_token& stop) {
        const std::vector<std::string>& cells = row.record.cells;
        for (std::size_t c = 0; c < cells.size(); ++c) {
            if (c > 0) text += ',';
            text += csvCell(cells[c]);
        }
        std::string reason = solve(row, text, stop);
        text += '\n';
        return reason;
    }

    std::string solve(const TableRow& row, std::string& text, const std::stop_token& stop) {
        if (const auto problems = m_assigner.assign(row); !problems.empty()) {
            text.append(m_outputs, ',');
            return "the table has changed since it was checked: " + problems.front();
        }
        if (m_movesPulse) m_solver.setPulse(m_assigner.scenario());
        return m_solver.solve(m_assigner.scenario(), text, stop);
    }

    TableRowAssigner m_assigner;
    std::size_t m_outputs;
    bool m_movesPulse;
    CaseSolver m_solver;
};

std::string headerText(const TableHeader& header, const std::vector<OutputColumn>& outputs) {
    std::string text;
    for (const TableColumn& column : header.columns) text += csvCell(column.text) + ",";
    for (const OutputColumn& output : outputs) text += output.header() + ",";
    text.back() = '\n';
    return text;
}

bool sets(const TableHeader& header, std::string_view key) {
    return std::ranges::find(header.columns, key, &TableColumn::key) != header.columns.end();
}

/// Why the outputs would be empty in every row.
std::string outputProblem(const Table& table, const TableHeader& header) {
    Scenario sample = table.base;
    if (sets(header, "drill.blow_frequency")) sample.drill.blowFrequency = 1;
    return columnProblem(table.columns, sample);
}

/// Reads and judges the header; an empty header when there is none.
TableHeader checkHeader(const Table& table, RowReader& reader, TableCheck& check) {
    CsvRecord record;
    if (!reader.header(record)) {
        check.problems.push_back(table.source + ": is empty; its first row must name parameters");
        return {};
    }
    const std::string place = table.source + ":" + std::to_string(reader.line());
    if (!record.problem.empty()) {
        check.problems.push_back(place + ": " + record.problem);
        return {};
    }
    TableHeader header = readTableHeader(record.cells, table.columns);
    const auto tell = [&](const std::vector<HeaderRemark>& remarks, std::vector<std::string>& lines) {
        for (const HeaderRemark& remark : remarks)
            lines.push_back(place + (remark.column > 0 ? ":" + std::to_string(remark.column) : "") + ": " +
                            remark.text);
    };
    tell(header.problems, check.problems);
    tell(header.warnings, check.warnings);
    if (check.problems.size() > maximumProblems) check.problems.resize(maximumProblems);
    if (const std::string problem = outputProblem(table, header); !problem.empty())
        check.problems.push_back(problem);
    return header;
}

constexpr RowRange allRows{0, UINT64_MAX};

}  // namespace

TableCheck checkTable(const Table& table, std::istream& cases, int jobs, std::stop_token stop) {
    TableCheck check;
    RowReader reader(cases, allRows);
    const TableHeader header = checkHeader(table, reader, check);
    if (!check.problems.empty()) return check;

    const auto makeWorker = [&] {
        return [assigner = TableRowAssigner(table.base, table.source, header)](Chunk& chunk,
                                                                               std::stop_token) mutable {
            chunk.problems.clear();
            for (std::size_t i = 0; i < chunk.used; ++i)
                for (std::string& problem : assigner.assign(chunk.rows[i]))
                    chunk.problems.push_back(std::move(problem));
        };
    };
    const auto deliver = [&](Chunk& chunk) {
        check.rows += chunk.used;
        for (std::string& problem : chunk.problems)
            if (check.problems.size() < maximumProblems) check.problems.push_back(std::move(problem));
        return check.problems.size() < maximumProblems;
    };
    check.end = processInOrder<Chunk>(
        jobs, stop, [&](Chunk& chunk) { return reader.fill(chunk); }, makeWorker, deliver);
    return check;
}

RowCounts runTable(const Table& table, std::istream& cases, std::uint64_t rows, int jobs,
                   std::stop_token stop, const WriteText& write, const RowProgress& progress) {
    RowCounts counts;
    RowReader reader(cases, rowsOf(table.shard, rows));
    CsvRecord record;
    reader.header(record);
    const TableHeader header = readTableHeader(record.cells, table.columns);
    if (table.shard.hasHeader() && !write(headerText(header, table.columns)))
        return {.failures = {}, .end = RowsEnd::stopped};

    const auto deliver = [&](Chunk& chunk) {
        if (!write(chunk.text)) return false;
        counts.add(chunk.used, chunk.failures);
        progress(counts);
        return true;
    };
    counts.end = processInOrder<Chunk>(
        jobs, stop, [&](Chunk& chunk) { return reader.fill(chunk); }, [&] { return RowMaker(table, header); },
        deliver);
    return counts;
}

}  // namespace drillwave
