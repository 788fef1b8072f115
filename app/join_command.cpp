// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave join PART… -o FILE
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "app/command.h"
#include "app/interruption.h"
#include "app/output_file.h"
#include "app/progress_bar.h"
#include "app/row_options.h"
#include "app/scenario_argument.h"
#include "core/archive/result_scenario.h"
#include "core/archive/row_record.h"
#include "core/disk/file_bytes.h"

namespace drillwave {

namespace {

constexpr std::string_view partOption[] = {"shard"};

/// A part, and the command of its record in words.
struct JoinedPart {
    RowPart part;
    Arguments arguments;
    std::string command;  ///< "drillwave sweep"
};

[[noreturn]] void refuse(const std::string& file, const Message& reason) {
    throw CommandError(ExitCode::unreadableInput, std::vector{about(file, reason)});
}

[[noreturn]] void refuseCommand(const RowPart& part, const Message& reason) {
    refuse(recordName(part.file), {translatable("its command does not exist in this version: %1"), {reason}});
}

Arguments argumentsOf(const RowPart& part, std::string& command) {
    const std::vector<std::string> words = shellWords(part.command);
    const Command* found = words.size() > 1 ? findCommand(words[1]) : nullptr;
    if (!found) refuseCommand(part, part.command);
    command = words[0] + " " + words[1];
    try {
        return Arguments::parse(std::span(words).subspan(2), found->options);
    } catch (const CommandError& error) {
        refuseCommand(part, error.messages().front());
    }
}

JoinedPart loadPart(const std::string& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error))
        refuse(file, std::filesystem::exists(file, error) ? translatable("is not a file of rows")
                                                          : translatable("the part does not exist"));
    const std::string record = recordName(file);
    const FileBytes bytes = readFile(record, maximumInputBytes);
    if (!bytes.problem.isEmpty())
        refuse(record, {translatable("%1; a part needs the record written with it"), {bytes.problem}});
    try {
        JoinedPart loaded{parseRowPart(bytes.bytes, file), {}, {}};
        loaded.arguments = argumentsOf(loaded.part, loaded.command);
        return loaded;
    } catch (const ScenarioError& problem) {
        rethrow(problem);
    }
}

/// Returns the difference of a part from another one, empty if they are of the same run. FILE may have
/// another name: its scenario is in the record.
Message difference(const JoinedPart& one, const JoinedPart& other) {
    if (std::string key = differingKey(one.part, other.part); !key.empty()) return key;
    if (one.part.shard.count != other.part.shard.count) return translatable("number of parts");
    const bool isSame = one.command == other.command &&
                        one.arguments.optionsText(partOption) == other.arguments.optionsText(partOption);
    return isSame ? Message() : Message(translatable("command"));
}

/// Loads the parts in their order. Throws if they do not make a whole.
std::vector<JoinedPart> loadParts(const std::vector<std::string>& files) {
    std::vector<JoinedPart> loaded;
    std::vector<Message> problems;
    for (const std::string& file : files) {
        loaded.push_back(loadPart(file));
        if (const Message key = difference(loaded.front(), loaded.back()); !key.isEmpty())
            problems.emplace_back(
                translatable(
                    "%1: belongs to another run than %2: its %3 differs; leave it out or run it again"),
                std::vector<Message>{file, files.front(), key});
    }
    std::vector<RowPart> parts;
    for (const JoinedPart& one : loaded) parts.push_back(one.part);
    if (problems.empty()) problems = wholeProblems(parts);
    if (!problems.empty()) throw CommandError(ExitCode::invalidScenario, std::move(problems));
    std::ranges::sort(loaded, {}, [](const JoinedPart& one) { return one.part.shard.index; });
    return loaded;
}

void copyRows(const RowPart& part, OutputFile& out, const Interruption& interruption) {
    std::ifstream stream(part.file, std::ios::binary);
    std::vector<char> block(std::size_t{1} << 20);
    FileSum sum;
    while (stream) {
        stream.read(block.data(), static_cast<std::streamsize>(block.size()));
        const std::string_view text(block.data(), static_cast<std::size_t>(stream.gcount()));
        sum.take(text);
        out.write(text);
        interruption.check();
    }
    if (!stream.eof()) refuse(part.file, translatable("cannot be read"));
    if (sum == part.sum) return;
    throw CommandError(
        ExitCode::invalidScenario,
        std::vector{
            Message(translatable("%1: differs from its record: it has %2 bytes with checksum %3, written "
                                 "were %4 and %5; it was changed or is another part, so run it again"),
                    {part.file, std::to_string(sum.bytes), sum.checksum(), std::to_string(part.sum.bytes),
                     part.sum.checksum()})});
}

/// The parts in a folder, by their records, without the rows there that are no part.
std::vector<std::string> partsIn(const std::string& folder) {
    std::vector<std::string> files;
    const std::string ending = recordName({});
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        std::string file = entry.path().string();
        if (!file.ends_with(ending)) continue;
        file.resize(file.size() - ending.size());
        std::error_code error;
        if (!std::filesystem::is_regular_file(file, error)) continue;
        const std::string record = readStart(recordName(file), maximumInputBytes).bytes;
        if (record.starts_with(rowRecordKey) && record.find("\npart: ") != std::string::npos)
            files.push_back(std::move(file));
    }
    std::ranges::sort(files);
    if (files.empty()) refuse(folder, translatable("has no parts of --shard with their records"));
    return files;
}

/// Returns the files of rows that the operands name: a folder stands for its parts, a record beside its rows
/// for nothing.
std::vector<std::string> filesOf(const std::vector<std::string>& operands) {
    std::vector<std::string> files;
    for (const std::string& operand : operands) {
        std::error_code error;
        const auto isRecordOf = [&](const std::string& other) { return operand == recordName(other); };
        if (std::filesystem::is_directory(operand, error))
            std::ranges::move(partsIn(operand), std::back_inserter(files));
        else if (std::ranges::none_of(operands, isRecordOf))
            files.push_back(operand);
    }
    return files;
}

ExitCode runJoin(const Arguments& arguments, const Drawing*) {
    const std::optional<std::string> path = arguments.value("o");
    if (!path)
        throw CommandError(ExitCode::usage,
                           translatable("needs -o FILE, where to write; - is standard output"));
    const Overwrite overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused;
    const std::vector<JoinedPart> parts = loadParts(filesOf(arguments.operands()));
    std::vector<std::string> inputs;
    WholeRows whole;
    for (const JoinedPart& one : parts) {
        inputs.insert(inputs.end(), {one.part.file, recordName(one.part.file)});
        whole.rows += one.part.rows;
        whole.unsolved += one.part.unsolved;
    }
    for (const std::string& output : {*path, recordName(*path)}) {
        checkNotInputFile(output, inputs);
        checkOverwrite(output, overwrite);
    }

    const Interruption interruption;
    OutputFile out(*path, overwrite);
    {
        ProgressBar bar(whole.rows, translatable("rows"), arguments.style());
        std::uint64_t copied = 0;
        for (const JoinedPart& one : parts) {
            copyRows(one.part, out, interruption);
            bar.show(copied += one.part.rows);
        }
    }
    const JoinedPart& first = parts.front();
    const std::string command = first.command + " " + first.arguments.shellText(partOption);
    whole.sum = out.sum();
    if (!isStream(*path))
        out.add({recordName(std::filesystem::path(*path).filename().string()),
                 wholeRecord(first.part, command, whole)});
    out.commit(&interruption);
    if (whole.unsolved == 0) return ExitCode::done;
    throw CommandError(ExitCode::unsolvedOrFailed, unsolvedRows(whole.unsolved, whole.rows));
}

}  // namespace

const Command& joinCommand() {
    static const Command command{
        .name = "join",
        .operands = "PART…",
        .summary = "combine the parts of a sweep, table or map that were solved with --shard",
        .details =
            "Writes FILE and its description FILE.yaml as one run without --shard would have written them, "
            "with\nthe same exit code. A PART is a file of rows with PART.yaml beside it, or a folder with "
            "all parts,\nin any order. All parts must come from the same run: same scenario, varied "
            "parameters, table of\ncases, build and number of parts. If a part is missing, given twice, from "
            "another run or changed\nsince it was written, the message names it; the exit code is 5.",
        .options = {{"o", "FILE", "write FILE and its description FILE.yaml; -o - prints the file instead"},
                    {"force", "", "overwrite existing files"}},
        .leastOperands = 1,
        .mostOperands = SIZE_MAX,
        .draws = [](const Arguments&) { return false; },
        .run = runJoin,
    };
    return command;
}

}  // namespace drillwave
