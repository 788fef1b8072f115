// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave signal RECORD…
#include "app/command.h"
#include "app/input_text.h"
#include "app/output_file.h"
#include "app/scenario_argument.h"
#include "app/signal_options.h"
#include "core/report/signal_report.h"

namespace drillwave {

namespace {

NamedReading readRecord(const std::string& path, const SignalOptions& options, const ReadingStyle& style) {
    RereadableInput input(path, RereadableInput::mostKept, style);
    return {inputName(path), readSignal(input.stream(), options)};
}

/// The code of one record: a question is open, or it could not be read.
ExitCode readingCode(const SignalReading& reading) {
    if (!reading.problem.isEmpty())
        return reading.isWrongOption ? ExitCode::invalidScenario : ExitCode::unreadableInput;
    return reading.isOpen() ? ExitCode::invalidScenario : ExitCode::done;
}

ExitCode worseOf(ExitCode a, ExitCode b) {
    if (a == ExitCode::unreadableInput || b == ExitCode::unreadableInput) return ExitCode::unreadableInput;
    return a == ExitCode::done ? b : a;
}

void writeSignal(const Arguments& arguments, const NamedReading& record, Overwrite overwrite) {
    const std::string path = *arguments.value("o");
    checkNotInputFile(path, arguments.operands());
    OutputFile file(path, overwrite);
    file.write(signalCsv(record.reading));
    file.commit();
}

void checkSignalOptions(const Arguments& arguments) {
    checkAboutFiles(arguments, {"force", "decimal-comma"}, "FILE.csv");
    if (arguments.has("o") && arguments.operands().size() > 1)
        throw CommandError(ExitCode::usage, translatable("-o takes one record; give one FILE"));
    arguments.checkOnePrinted();
}

ExitCode runSignal(const Arguments& arguments, const Drawing*) {
    checkSignalOptions(arguments);
    const SignalOptions options = signalOptionsOf(arguments);
    const Overwrite overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused;
    if (const auto path = arguments.value("o")) {
        checkNotInputFile(*path, arguments.operands());
        checkOutput(*path, overwrite);
    }
    std::vector<NamedReading> records;
    ExitCode code = ExitCode::done;
    for (const std::string& path : arguments.operands()) {
        try {
            records.push_back(readRecord(path, options, arguments.style()));
        } catch (const CommandError& error) {
            if (arguments.operands().size() == 1) throw;
            for (const Message& line : error.messages()) printRemark(line, arguments.style());
            records.push_back({inputName(path), {}});
            records.back().reading.problem = translatable("cannot be read");
            code = worseOf(code, error.code());
            continue;
        }
        const SignalReading& reading = records.back().reading;
        code = worseOf(code, readingCode(reading));
        if (!reading.problem.isEmpty())
            printRemark(about(records.back().file, reading.problem), arguments.style());
    }
    saveRecorder(arguments);
    const NamedReading& first = records.front();
    const bool isSeries = records.size() > 1;
    const bool isPrinted = arguments.value("o") != "-";
    if (arguments.has("json")) {
        JsonArray array;
        for (const NamedReading& record : records) {
            if (record.reading.problem.isEmpty())
                array.emplace_back(signalJson(record));
            else
                array.emplace_back(
                    JsonObject{{"file", record.file}, {"problem", record.reading.problem.text()}});
        }
        if (isSeries || first.reading.problem.isEmpty())
            printText(isSeries ? Json(std::move(array)).text() : array.front().text());
    } else if (isSeries) {
        printText(signalSeriesText(records, arguments.style()));
    } else if (first.reading.problem.isEmpty() && isPrinted) {
        printText(signalText(first, arguments.style()));
    }
    if (arguments.has("o") && code == ExitCode::done) writeSignal(arguments, first, overwrite);
    return code;
}

}  // namespace

const Command& signalCommand() {
    static constexpr std::string_view details =
        "Reads tables of a signal measured over time, and finds encoding, separator, decimal sign, "
        "columns\nand units. If the table does not state something that is needed, the last lines printed "
        "ask for\nit, and the exit code is 5. Several RECORDs are read as one series and give one row each. "
        "Commands\nthat take a scenario can use such a record as the blow, with --signal FILE and the same "
        "options.";
    static const Command command{
        .name = "signal",
        .operands = "RECORD…",
        .summary = "read records of force, strain or voltage; print their units, blow and quality",
        .details = details,
        .options =
            [] {
                std::vector<OptionSpec> specs = signalOptionSpecs();
                specs.push_back({"save-recorder", "NAME",
                                 "save the options for reading the record under this name; --recorder NAME "
                                 "uses them again"});
                specs.push_back({"json", "", "print JSON; for several FILEs, an array"});
                specs.push_back(
                    {"o", "FILE.csv", "write the signal as read, with the columns time [us] and force [kN]"});
                specs.push_back(decimalCommaSpec());
                specs.push_back({"force", "", "overwrite FILE.csv if it exists"});
                return specs;
            }(),
        .leastOperands = 1,
        .mostOperands = SIZE_MAX,
        .draws = [](const Arguments&) { return false; },
        .run = runSignal,
    };
    return command;
}

}  // namespace drillwave
