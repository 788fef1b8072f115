// drillwave table FILE CASES.csv
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "app/command.h"
#include "app/row_options.h"
#include "app/scenario_argument.h"
#include "core/study/table.h"

namespace drillwave {

namespace {

/// The rows are read twice, to check them all before the first is solved: a pipe will not do.
std::ifstream openCases(const std::string& path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status))
        throw CommandError(ExitCode::unreadableInput, path + ": cannot be opened: No such file or directory");
    if (!std::filesystem::is_regular_file(status))
        throw CommandError(ExitCode::unreadableInput,
                           path + ": is not a regular file; write the rows to a file first");
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw CommandError(ExitCode::unreadableInput,
                           path + ": cannot be opened for reading; check its permissions");
    return file;
}

/// Prints warnings, throws problems, returns the number of rows.
std::uint64_t check(const Table& table, std::ifstream& cases, int jobs, const Interruption& interruption) {
    TableCheck found = checkTable(table, cases, jobs, interruption.token());
    interruption.check();
    if (!found.problems.empty()) throw CommandError(ExitCode::invalidScenario, std::move(found.problems));
    for (const std::string& warning : found.warnings) std::fprintf(stderr, "%s\n", warning.c_str());
    cases.clear();
    cases.seekg(0);
    return found.rows;
}

ExitCode runTableCommand(const Arguments& arguments) {
    const RowOptions options = rowOptions(arguments);
    const std::string& path = arguments.operands()[1];
    const ScenarioDocument base = loadScenarioArgument(arguments.operands()[0], arguments);
    checkOutputIsNoInput(options.path, arguments.operands()[0], base, {path});
    const Table table{.base = base.scenario,
                      .source = path,
                      .columns = options.columns,
                      .shard = options.shard,
                      .method = options.method,
                      .workLimit = options.workLimit};
    std::ifstream cases = openCases(path);
    const Interruption interruption;
    OutputFile out(options.path, options.overwrite);
    const std::uint64_t rows = check(table, cases, options.jobs, interruption);
    const auto run = [&](std::stop_token stop, const WriteText& write, const RowProgress& progress) {
        return runTable(table, cases, rows, options.jobs, stop, write, progress);
    };
    return writeRows(run, rowsOf(table.shard, rows).size(), options, out, interruption);
}

}  // namespace

const Command& tableCommand() {
    static const std::string details =
        "The header of CASES names parameters, with a unit in brackets or units in the cells: rod.length "
        "[m].\n"
        "An empty cell leaves the value of FILE. Columns that are no parameters are passed through.\n" +
        outputHelp();
    static const Command command{
        .name = "table",
        .operands = "FILE CASES.csv",
        .summary = "solve every row of a table of cases; its columns and the outputs",
        .details = details,
        .options = rowOptionSpecs(),
        .leastOperands = 2,
        .mostOperands = 2,
        .draws = [](const Arguments&) { return false; },
        .run = runTableCommand,
    };
    return command;
}

}  // namespace drillwave
