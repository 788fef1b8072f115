// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave table FILE CASES.csv
#include <fstream>

#include "app/command.h"
#include "app/input_text.h"
#include "app/method_options.h"
#include "app/row_options.h"
#include "app/scenario_argument.h"
#include "core/study/rows/table.h"

namespace drillwave {

namespace {

/// Prints warnings, throws problems, returns the number of rows.
std::uint64_t check(const Table& table, std::istream& cases, int jobs, const ReadingStyle& style,
                    const Interruption& interruption) {
    TableCheck found = checkTable(table, cases, jobs, interruption.token());
    interruption.check();
    if (!found.problems.empty()) throw CommandError(ExitCode::invalidScenario, std::move(found.problems));
    for (const Message& warning : found.warnings) printRemark(warning, style);
    cases.clear();
    cases.seekg(0);
    return found.rows;
}

ExitCode runTableCommand(const Arguments& arguments, const Drawing*) {
    const std::string& scenarioPath = arguments.operands()[0];
    const std::string& path = arguments.operands()[1];
    if (isStandardInput(scenarioPath) && isStandardInput(path))
        throw CommandError(ExitCode::usage,
                           translatable("FILE and CASES are both standard input; give a name for one"));
    const ScenarioInput input = loadScenarioInput(scenarioPath, arguments);
    const ScenarioDocument& base = input.document;
    const RowOptions options = rowOptions(arguments, input.method);
    checkMethodOfString(options.method, input.document.scenario, scenarioPath);
    checkRows(options, arguments, base);
    Table table{.base = base.scenario,
                .source = inputName(path),
                .columns = options.columnsFor(base.scenario),
                .shard = options.shard,
                .method = options.method,
                .workLimit = options.workLimit};
    RereadableInput cases(path, RereadableInput::mostKept, arguments.style());
    const Interruption interruption;
    const std::uint64_t rows = check(table, cases.stream(), options.jobs, arguments.style(), interruption);
    RowRecord record =
        recordOf("table", arguments, options, table.columns, base, rowsOf(table.shard, rows).size());
    record.cases = inputName(path);
    record.casesFile = sumOf(cases.stream());
    cases.stream().clear();
    cases.stream().seekg(0);
    const auto run = [&](std::stop_token stop, RowSink& sink, const RowProgress& progress,
                         std::uint64_t done) {
        table.done = done;
        return runTable(table, cases.stream(), rows, options.jobs, stop, sink, progress);
    };
    return writeRows(run, record, options, interruption, arguments.style());
}

}  // namespace

const Command& tableCommand() {
    static constexpr std::string_view details =
        "CASES.csv is a table with one case in each row. Its header names parameters, with a unit in\n"
        "brackets, as in rod.length [m], or with units in the cells. An empty cell keeps the value of FILE.\n"
        "Columns that are not parameters are copied to the output. CASES can be - (standard input) or a\n"
        "pipe. FILE.csv.yaml beside FILE.csv records version, command and scenario.";
    static const Command command{
        .name = "table",
        .operands = "FILE CASES.csv",
        .summary = "solve every row of a table of cases; write its columns and the outputs",
        .details = details,
        .furtherHelp = outputHelp,
        .options = rowOptionSpecs(),
        .leastOperands = 2,
        .mostOperands = 2,
        .draws = [](const Arguments&) { return false; },
        .run = runTableCommand,
    };
    return command;
}

}  // namespace drillwave
