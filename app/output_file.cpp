// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>

#include "app/command_error.h"
#include "core/file/whole_folder.h"
#include "core/text/text_input.h"

namespace drillwave {

namespace {

bool isStandardOutput(const std::string& path) {
    return path == "-";
}

/// Something like /dev/null or a pipe, which cannot be replaced by a file.
bool isDevice(const std::string& path) {
    std::error_code ignored;
    const auto status = std::filesystem::status(path, ignored);
    return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
           !std::filesystem::is_directory(status);
}

}  // namespace

void checkName(const std::string& path) {
    if (!isUtf8(path))
        throw CommandError(ExitCode::unwritableOutput,
                           path + ": the name has bytes that are not UTF-8; choose another one");
}

void checkOverwrite(const std::string& path, Overwrite overwrite) {
    checkName(path);
    if (isStandardOutput(path) || isDevice(path)) return;
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        throw CommandError(ExitCode::unwritableOutput, path + ": is a folder; give the name of a file");
    // A dangling link is something that would be written through.
    if (isThere(path) && overwrite == Overwrite::refused)
        throw CommandError(ExitCode::unwritableOutput,
                           path + ": exists already; use --force to overwrite it or choose another name");
}

OutputFile::OutputFile(const std::string& path, Overwrite overwrite) : m_path(path) {
    checkOverwrite(path, overwrite);
    if (isStandardOutput(path)) return;
    if (isDevice(path)) {
        m_device = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
        check(m_device < 0 ? writeFailure(errno) : WriteFailure{});
        return;
    }
    m_file = std::make_unique<WholeFile>(path);
    check(m_file->open());
}

OutputFile::~OutputFile() {
    if (m_device >= 0) ::close(m_device);
}

void OutputFile::write(std::string_view text) {
    if (m_file)
        check(m_file->write(text));
    else if (m_device >= 0)
        check(writeAll(m_device, text));
    else if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size())
        check(writeFailure(errno));
}

void OutputFile::flush() {
    // The C library holds the last bytes for standard output back, and would lose them without a word.
    if (isStandardOutput(m_path) && std::fflush(stdout) != 0) check(writeFailure(errno));
}

void OutputFile::commit() {
    flush();
    if (m_file) check(m_file->commit());
}

void OutputFile::check(const WriteFailure& failure) const {
    if (!failure) return;
    const std::string name = isStandardOutput(m_path) ? "standard output" : m_path;
    throw CommandError(ExitCode::unwritableOutput, name + ": cannot be written: " + failure.reason + "; " +
                                                       (failure.isFull ? "free some space or " : "") +
                                                       "choose another place with -o");
}

void writeFile(const std::string& path, std::string_view text, Overwrite overwrite) {
    OutputFile file(path, overwrite);
    file.write(text);
    file.commit();
}

}  // namespace drillwave
