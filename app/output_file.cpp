// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <cstdio>
#include <filesystem>

#include "app/command_error.h"
#include "app/output_folder.h"
#include "core/disk/hidden_folder.h"
#include "core/text/name_text.h"
#include "core/text/text_input.h"

namespace drillwave {

namespace {

/// Signs of the CSV of this run of the program.
CsvSigns csvSigns = CsvSigns::pointAndComma;

constexpr const char* standardOutput = translatable("standard output");

bool isStandardOutput(const std::string& path) {
    return path == "-" || path == "/dev/stdout";
}

/// Something like /dev/null or a pipe, which cannot be replaced by a file.
bool isDevice(const std::string& path) {
    std::error_code ignored;
    const auto status = std::filesystem::status(path, ignored);
    return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
           !std::filesystem::is_directory(status);
}

std::string folderOf(const std::string& path) {
    const std::string folder = std::filesystem::path(path).parent_path();
    return folder.empty() ? "." : folder;
}

std::string nameOf(const std::string& path) {
    return std::filesystem::path(path).filename();
}

}  // namespace

void checkAboutFiles(const Arguments& arguments, std::initializer_list<const char*> options,
                     const char* output) {
    if (arguments.has("o")) return;
    for (const char* option : options)
        if (arguments.has(option))
            throw CommandError(ExitCode::usage, Message(translatable("%1 applies to files; add -o %2"),
                                                        {std::string("--") + option, std::string(output)}));
}

OptionSpec decimalCommaSpec() {
    return {"decimal-comma", "", "write CSV with semicolons between cells and decimal commas"};
}

void useCsvSigns(const Arguments& arguments) {
    csvSigns = arguments.has("decimal-comma") ? CsvSigns::commaAndSemicolon : CsvSigns::pointAndComma;
}

std::string inCsvSigns(std::string_view csv) {
    return CsvInSigns(csvSigns).text(csv);
}

std::string bytesInSigns(const NamedFile& file) {
    return file.name.ends_with(".csv") ? inCsvSigns(file.bytes) : file.bytes;
}

bool isStream(const std::string& path) {
    return isStandardOutput(path) || isDevice(path);
}

void checkStandardOutput() {
    if (::fcntl(STDOUT_FILENO, F_GETFL) < 0 || (::fcntl(STDOUT_FILENO, F_GETFL) & O_ACCMODE) == O_RDONLY)
        throw CommandError(
            ExitCode::unwritableOutput,
            about(standardOutput, translatable("is closed; send it to a file or to /dev/null")));
}

void checkName(const std::string& path) {
    if (!isUtf8(path))
        throw CommandError(ExitCode::unwritableOutput,
                           about(path, translatable("the name is not UTF-8; choose another one")));
}

void checkOverwrite(const std::string& path, Overwrite overwrite) {
    checkName(path);
    if (isStream(path)) return;
    std::error_code ignored;
    if (path.ends_with('/') || std::filesystem::is_directory(path, ignored))
        throw CommandError(ExitCode::unwritableOutput,
                           about(path, translatable("is a folder; give the name of a file")));
    // A dangling link is something that would be written through.
    if (isThere(path) && overwrite == Overwrite::refused)
        throw CommandError(
            ExitCode::unwritableOutput,
            about(path, translatable("exists already; use --force to overwrite it or choose another name")));
}

void checkOutput(const std::string& path, Overwrite overwrite, LeftBeside leftBeside) {
    checkName(path);
    if (isStream(path)) return;
    const std::string folder = folderOf(path);
    mendFolder(folder);
    if (const Message problem = lockProblem(folder); !problem.isEmpty())
        throw CommandError(ExitCode::unwritableOutput, problem);
    checkOverwrite(path, overwrite);
    for (const std::string& name : leftBeside(folder, nameOf(path)))
        checkOverwrite(pathInside(folder, name), overwrite);
}

OutputFile::OutputFile(const std::string& path, Overwrite overwrite, LeftBeside leftBeside)
    : m_path(path), m_overwrite(overwrite), m_leftBeside(leftBeside), m_csv(csvSigns) {
    checkOutput(path, overwrite, leftBeside);
    if (isStandardOutput(path)) {
        checkStandardOutput();
        return;
    }
    if (isDevice(path)) {
        m_device = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
        check(m_device < 0 ? writeFailure(errno) : WriteFailure{});
        return;
    }
    m_file = std::make_unique<WholeFile>(path);
    check(m_file->open());
}

OutputFile::OutputFile(const std::string& path, Overwrite overwrite, const KeptRows& kept)
    : m_path(path),
      m_overwrite(overwrite),
      m_leftBeside(studyFilesThere),
      m_file(std::make_unique<WholeFile>(path)),
      m_csv(csvSigns),
      m_sum(kept.done().sum) {
    checkOutput(path, overwrite);
    check(m_file->openKept(kept.path(), m_sum.bytes));
}

OutputFile::~OutputFile() {
    if (m_device >= 0) ::close(m_device);
}

void OutputFile::write(std::string_view csv) {
    if (csvSigns == CsvSigns::pointAndComma)
        writeText(csv);
    else
        writeText(m_csv.text(csv));
}

void OutputFile::writeText(std::string_view text) {
    if (m_file)
        check(m_file->write(text));
    else if (m_device >= 0)
        check(writeAll(m_device, text));
    else if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size())
        check(writeFailure(errno));
    m_sum.take(text);
}

void OutputFile::add(NamedFile beside) {
    assert(m_file);
    beside.bytes = bytesInSigns(beside);
    m_beside.push_back(std::move(beside));
}

void OutputFile::flush() {
    // The C library holds the last bytes for standard output back, and would lose them without a word.
    if (isStandardOutput(m_path) && std::fflush(stdout) != 0) check(writeFailure(errno));
}

void OutputFile::commit(const Interruption* interruption) {
    if (!m_file) return flush();
    const std::string name = nameOf(m_file->path());
    FolderFiles files;
    files.files = std::move(m_beside);
    files.outdated = [this, name](const std::string& folder) { return m_leftBeside(folder, name); };
    files.last = m_file.get();
    writeFolder(folderOf(m_file->path()), files, m_overwrite, interruption);
}

void OutputFile::check(const WriteFailure& failure) const {
    if (!failure) return;
    const Message name = isStandardOutput(m_path) ? Message(standardOutput) : Message(m_path);
    throw CommandError(
        ExitCode::unwritableOutput,
        Message(
            failure.isFull
                ? translatable("%1: cannot be written: %2; free some space or choose another place with -o")
                : translatable("%1: cannot be written: %2; choose another place with -o"),
            {name, failure.reason}));
}

void printText(std::string_view text) {
    OutputFile out("-", Overwrite::allowed);
    out.writeText(printableLines(text));
    out.commit();
}

}  // namespace drillwave
