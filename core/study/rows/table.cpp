// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rows/table.h"

#include <algorithm>
#include <span>

#include "core/signal/case_records.h"
#include "core/study/rows/case_solver.h"
#include "core/study/rows/row_run.h"
#include "core/study/rows/table_header.h"
#include "core/study/rows/table_row.h"
#include "core/text/csv.h"

namespace drillwave {

namespace {

/// Limits of a chunk: rows to hand over at once, and bytes so that long cells cost no more memory.
constexpr std::size_t chunkRows = 256;
constexpr std::size_t chunkBytes = 1 << 18;
constexpr std::size_t maximumProblems = 20;

struct TableChunk : RowChunk {
    std::uint64_t first = 0;  // number of the first row of all rows
    std::vector<CsvRecord> records;
    std::vector<int> lines;  // of each record, from 1
    std::size_t used = 0;    // rows of this chunk; the rest are kept for their memory
    std::vector<Message> problems;
};

/// Reads the rows of a range, numbered from the row below the header.
class RowReader {
  public:
    RowReader(std::istream& cases, RowRange range) : m_reader(cases), m_range(range) {}

    bool header(CsvRecord& record) { return m_reader.next(record); }
    /// Steps over the rows before the range.
    void skip() { m_next = m_reader.skip(m_range.begin); }
    int line() const { return m_reader.line(); }

    bool fill(TableChunk& chunk) {
        chunk.first = m_next;
        chunk.used = 0;
        std::size_t bytes = 0;
        while (m_next < m_range.end && chunk.used < chunkRows && bytes < chunkBytes) {
            if (chunk.used == chunk.records.size()) {
                chunk.records.emplace_back();
                chunk.lines.push_back(0);
            }
            CsvRecord& record = chunk.records[chunk.used];
            if (!m_reader.next(record)) break;
            chunk.lines[chunk.used] = m_reader.line();
            ++m_next;
            for (const std::string& cell : record.cells) bytes += cell.size() + sizeof(std::string);
            ++chunk.used;
        }
        return chunk.used > 0;
    }

  private:
    CaseRecords m_reader;
    RowRange m_range;
    std::uint64_t m_next = 0;
};

/// Solves rows. One for each thread.
class TableRowMaker {
  public:
    TableRowMaker(const Table& table, const TableHeader& header)
        : m_assigner(table.base, table.source, header),
          m_outputs(table.columns.size()),
          m_movesPulse(header.assignments().movePulse()),
          m_solver(table.columns, table.method, table.workLimit) {
        m_solver.setPulse(table.base);
    }

    void operator()(TableChunk& chunk, std::stop_token stop) {
        chunk.rows.restart(chunk.first, m_outputs);
        chunk.rows.copy(std::span(chunk.records).first(chunk.used));
        for (std::size_t i = 0; i < chunk.used; ++i) {
            if (stop.stop_requested()) return;
            const std::span<double> outputs = chunk.rows.add();
            Message reason = solve(chunk.records[i], chunk.lines[i], outputs, stop);
            if (!reason.isEmpty()) chunk.rows.fail(std::move(reason));
        }
    }

  private:
    /// Returns why the row could not be solved.
    Message solve(const CsvRecord& record, int line, std::span<double> outputs, const std::stop_token& stop) {
        if (const auto problems = m_assigner.assign(record, line); !problems.empty())
            return {translatable("the table has changed since it was checked: %1"), {problems.front()}};
        if (m_movesPulse) m_solver.setPulse(m_assigner.scenario());
        return m_solver.solve(m_assigner.scenario(), outputs, stop);
    }

    TableRowAssigner m_assigner;
    std::size_t m_outputs;
    bool m_movesPulse;
    CaseSolver m_solver;
};

RowHeader headerOf(const Table& table, const TableHeader& header) {
    RowHeader all{.copied = {}, .columns = {}, .isFirstPart = table.shard.hasHeader() && table.done == 0};
    for (const CaseColumn& column : header.columns) all.copied.push_back(column.text);
    for (const OutputColumn& column : table.columns) all.columns.push_back({.header = column.header()});
    return all;
}

bool sets(const TableHeader& header, std::string_view key) {
    return std::ranges::find(header.columns, key, &CaseColumn::key) != header.columns.end();
}

/// Why the outputs would be empty in every row.
Message outputProblem(const Table& table, const TableHeader& header) {
    Scenario sample = table.base;
    if (sets(header, "drill.blow_frequency")) sample.drill.blowFrequency = 1;
    if (sets(header, "drill.thrust")) sample.drill.thrust = 1;
    return columnProblem(table.columns, sample);
}

/// Reads and judges the header; an empty header when there is none.
TableHeader checkHeader(const Table& table, RowReader& reader, TableCheck& check) {
    CsvRecord record;
    if (!reader.header(record)) {
        check.problems.push_back(
            about(table.source, translatable("is empty; its first row must name parameters")));
        return {};
    }
    const std::string place = table.source + ":" + std::to_string(reader.line());
    if (!record.problem.isEmpty()) {
        check.problems.push_back(about(place, record.problem));
        return {};
    }
    TableHeader header = readTableHeader(record.cells, table.columns);
    const auto tell = [&](const std::vector<HeaderRemark>& remarks, std::vector<Message>& lines) {
        for (const HeaderRemark& remark : remarks)
            lines.push_back(
                about(place + (remark.column > 0 ? ":" + std::to_string(remark.column) : ""), remark.text));
    };
    tell(header.problems, check.problems);
    tell(header.warnings, check.warnings);
    if (check.problems.size() > maximumProblems) check.problems.resize(maximumProblems);
    if (const Message problem = outputProblem(table, header); !problem.isEmpty())
        check.problems.push_back(problem);
    return header;
}

constexpr RowRange allRows{0, UINT64_MAX};

/// Rows below the header, counted without reading their cells.
std::uint64_t countRows(std::istream& cases) {
    CaseRecords reader(cases);
    return std::max(reader.skip(UINT64_MAX), std::uint64_t{1}) - 1;
}

}  // namespace

TableCheck checkTable(const Table& table, std::istream& cases, int jobs, std::stop_token stop) {
    TableCheck check;
    RowRange range = allRows;
    if (table.shard.count > 1) {
        check.rows = countRows(cases);
        cases.clear();
        cases.seekg(0);
        range = rowsOf(table.shard, check.rows);
    }
    RowReader reader(cases, range);
    const TableHeader header = checkHeader(table, reader, check);
    if (!check.problems.empty()) return check;
    reader.skip();

    const auto makeWorker = [&] {
        return [assigner = TableRowAssigner(table.base, table.source, header)](TableChunk& chunk,
                                                                               std::stop_token) mutable {
            chunk.problems.clear();
            for (std::size_t i = 0; i < chunk.used; ++i)
                for (Message& problem : assigner.assign(chunk.records[i], chunk.lines[i]))
                    chunk.problems.push_back(std::move(problem));
        };
    };
    const auto deliver = [&](TableChunk& chunk) {
        if (table.shard.count == 1) check.rows += chunk.used;
        for (Message& problem : chunk.problems)
            if (check.problems.size() < maximumProblems) check.problems.push_back(std::move(problem));
        return check.problems.size() < maximumProblems;
    };
    check.end = processInOrder<TableChunk>(
        jobs, stop, [&](TableChunk& chunk) { return reader.fill(chunk); }, makeWorker, deliver);
    return check;
}

RowCounts runTable(const Table& table, std::istream& cases, std::uint64_t rows, int jobs,
                   std::stop_token stop, RowSink& sink, const RowProgress& progress) {
    RowRange part = rowsOf(table.shard, rows);
    part.begin = std::min(part.begin + table.done, part.end);
    RowReader reader(cases, part);
    CsvRecord record;
    reader.header(record);
    reader.skip();
    const TableHeader header = readTableHeader(record.cells, table.columns);
    return runRows<TableChunk>(
        jobs, stop, [&](TableChunk& chunk) { return reader.fill(chunk); },
        [&] { return TableRowMaker(table, header); }, headerOf(table, header), sink, progress);
}

}  // namespace drillwave
