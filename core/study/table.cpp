#include "core/study/table.h"

#include <algorithm>
#include <optional>

#include "core/file/csv.h"
#include "core/model/validation.h"
#include "core/study/case_solver.h"
#include "core/study/table_header.h"

namespace drillwave {

namespace {

/// Limits of a chunk: rows to hand over at once, and bytes so that long cells cost no more memory.
constexpr std::size_t chunkRows = 256;
constexpr std::size_t chunkBytes = 1 << 18;
constexpr std::size_t maximumProblems = 20;

struct Row {
    CsvRecord record;
    int line = 0;
};

struct Chunk {
    std::vector<Row> rows;
    std::size_t used = 0;  // rows of this chunk; the rest are kept for their memory
    std::string text;
    std::uint64_t failed = 0;
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
            Row& row = chunk.rows[chunk.used];
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

/// Sets the cells of one row after another. One for each thread.
class RowAssigner {
  public:
    RowAssigner(const Table& table, const TableHeader& header)
        : m_table(table), m_header(header), m_order(header.assignmentOrder()), m_scenario(table.base) {}

    /// The scenario of the row last assigned.
    const Scenario& scenario() const { return m_scenario; }

    /// What is wrong with the row, empty when scenario() is its valid scenario.
    std::vector<std::string> assign(const Row& row) {
        std::vector<std::string> problems = assignCells(row);
        if (!problems.empty()) return problems;
        for (const Problem& problem : validate(m_scenario))
            problems.push_back(place(row) + ": " + problem.text);
        return problems;
    }

  private:
    std::vector<std::string> assignCells(const Row& row) {
        const std::vector<std::string>& cells = row.record.cells;
        if (!row.record.problem.empty()) return {place(row) + ": " + row.record.problem};
        if (cells.size() != m_header.columns.size())
            return {place(row) + ": has " + std::to_string(cells.size()) + " cells, the header has " +
                    std::to_string(m_header.columns.size())};
        std::vector<std::string> problems;
        m_scenario = m_table.base;
        for (const std::size_t i : m_order) {
            if (cells[i].empty()) continue;
            const TableColumn& column = m_header.columns[i];
            const std::string problem = assignText(m_scenario, column.key(), cells[i], column.unit);
            if (!problem.empty())
                problems.push_back(place(row) + ":" + std::to_string(i + 1) + ": " + problem);
        }
        return problems;
    }

    std::string place(const Row& row) const { return m_table.source + ":" + std::to_string(row.line); }

    const Table& m_table;
    const TableHeader& m_header;
    std::vector<std::size_t> m_order;
    Scenario m_scenario;
};

/// Solves rows into text. One for each thread.
class RowMaker {
  public:
    RowMaker(const Table& table, const TableHeader& header)
        : m_assigner(table, header), m_outputs(table.columns.size()), m_solver(table.columns, table.method) {
        m_solver.setPulse(table.base);
        for (const TableColumn& column : header.columns)
            if (column.key().starts_with("pulse.") || column.key().starts_with("rod.")) m_movesPulse = true;
    }

    void operator()(Chunk& chunk, std::stop_token stop) {
        chunk.text.clear();
        chunk.failed = 0;
        for (std::size_t i = 0; i < chunk.used; ++i) {
            if (stop.stop_requested()) return;
            if (!appendRow(chunk.rows[i], chunk.text, stop)) ++chunk.failed;
        }
    }

  private:
    bool appendRow(const Row& row, std::string& text, const std::stop_token& stop) {
        const std::vector<std::string>& cells = row.record.cells;
        for (std::size_t c = 0; c < cells.size(); ++c) {
            if (c > 0) text += ',';
            text += csvCell(cells[c]);
        }
        const bool solved = solve(row, text, stop);
        text += '\n';
        return solved;
    }

    bool solve(const Row& row, std::string& text, const std::stop_token& stop) {
        if (!m_assigner.assign(row).empty()) {
            text.append(m_outputs, ',');
            return false;
        }
        if (m_movesPulse) m_solver.setPulse(m_assigner.scenario());
        return m_solver.solve(m_assigner.scenario(), text, stop);
    }

    RowAssigner m_assigner;
    std::size_t m_outputs;
    bool m_movesPulse = false;
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
    const std::string place = table.source + ":" + std::to_string(reader.line()) + ": ";
    if (!record.problem.empty()) {
        check.problems.push_back(place + record.problem);
        return {};
    }
    TableHeader header = readTableHeader(record.cells);
    for (const std::string& problem : header.problems) check.problems.push_back(place + problem);
    for (const std::string& warning : header.warnings) check.warnings.push_back(place + warning);
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
        return [assigner = RowAssigner(table, header)](Chunk& chunk, std::stop_token) mutable {
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
    const TableHeader header = readTableHeader(record.cells);
    if (table.shard.hasHeader() && !write(headerText(header, table.columns)))
        return {.end = RowsEnd::stopped};

    const auto deliver = [&](Chunk& chunk) {
        if (!write(chunk.text)) return false;
        counts.rows += chunk.used;
        counts.failed += chunk.failed;
        progress(counts);
        return true;
    };
    counts.end = processInOrder<Chunk>(
        jobs, stop, [&](Chunk& chunk) { return reader.fill(chunk); }, [&] { return RowMaker(table, header); },
        deliver);
    return counts;
}

}  // namespace drillwave
