// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/archive/kept_rows.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <optional>
#include <vector>

#include "core/archive/result_files.h"
#include "core/disk/hidden_folder.h"
#include "core/text/decimal_text.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {
namespace {

constexpr std::string_view notesBegin = "done:\n";
constexpr std::chrono::milliseconds betweenNotes{200};

std::string noteOf(const RowsDone& done) {
    return "  - [" + std::to_string(done.rows) + ", " + std::to_string(done.unsolved) + ", " +
           std::to_string(done.sum.bytes) + ", \"" + done.sum.checksum() + "\"]\n";
}

/// The inverse of noteOf(); nothing of a line that is none.
std::optional<RowsDone> readNote(std::string_view line) {
    std::vector<std::string_view> fields;
    for (std::size_t begin = line.find('['), end = 0; begin != line.npos && end != line.npos; begin = end) {
        end = line.find(',', ++begin);
        fields.push_back(trimmed(line.substr(begin, std::min(end, line.find(']')) - begin)));
    }
    if (fields.size() != 4 || fields[3].size() < 2) return std::nullopt;
    const auto rows = wholeNumberIn<std::uint64_t>(fields[0]);
    const auto unsolved = wholeNumberIn<std::uint64_t>(fields[1]);
    const auto bytes = wholeNumberIn<std::uint64_t>(fields[2]);
    const auto crc32 = checksumOf(fields[3].substr(1, fields[3].size() - 2));
    if (!rows || !unsolved || !bytes || !crc32) return std::nullopt;
    RowsDone done{.rows = *rows, .unsolved = *unsolved, .sum = {.bytes = *bytes, .crc32 = *crc32}};
    return noteOf(done) == std::string(line) + "\n" ? std::optional(done) : std::nullopt;
}

/// The sum of the first bytes of a file.
FileSum sumOfStart(const std::string& path, std::uint64_t bytes) {
    std::ifstream stream(path, std::ios::binary);
    std::vector<char> block(std::size_t{1} << 18);
    FileSum sum;
    while (stream && sum.bytes < bytes) {
        stream.read(block.data(),
                    static_cast<std::streamsize>(std::min<std::uint64_t>(block.size(), bytes - sum.bytes)));
        sum.take({block.data(), static_cast<std::size_t>(stream.gcount())});
    }
    return sum;
}

std::string readAll(int descriptor) {
    std::string text;
    std::vector<char> block(std::size_t{1} << 16);
    for (ssize_t got = 0; (got = ::read(descriptor, block.data(), block.size())) > 0;)
        text.append(block.data(), static_cast<std::size_t>(got));
    return text;
}

}  // namespace

KeptRows::KeptRows(const std::string& file, const std::string& entries, Other other)
    : m_path(file + ".partial"), m_notes(recordName(m_path)) {
    open(entries + std::string(notesBegin), other);
}

KeptRows::~KeptRows() {
    if (m_descriptor >= 0) ::close(m_descriptor);
}

void KeptRows::open(const std::string& entries, Other other) {
    m_descriptor = ::open(m_notes.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_APPEND, 0666);
    if (m_descriptor < 0) {
        m_problem = notWritten(m_notes, writeFailure(errno));
        return;
    }
    if (::flock(m_descriptor, LOCK_EX | LOCK_NB) != 0 && !isLockingUnsupported(errno)) {
        m_problem = {translatable("%1: another process writes these rows; wait for it, or end it"),
                     {m_notes}};
        return;
    }
    const std::string text = readAll(m_descriptor);
    const std::string_view begun(text);
    if (begun.starts_with(entries)) {
        const std::uint64_t read = takeUp(begun.substr(entries.size()));
        if (::ftruncate(m_descriptor, static_cast<off_t>(entries.size() + read)) != 0)
            m_problem = notWritten(m_notes, writeFailure(errno));
        return;
    }
    // One that died at its first bytes has left less than it would.
    if (other == Other::isProblem && !std::string_view(entries).starts_with(begun)) {
        m_problem = {translatable("%1: belongs to another run (other options, inputs or build); use --force "
                                  "to start again, or choose another name"),
                     {m_notes, m_path}};
        return;
    }
    const int cut = ::ftruncate(m_descriptor, 0);
    const WriteFailure failure = cut != 0 ? writeFailure(errno) : writeAll(m_descriptor, entries);
    if (failure) m_problem = notWritten(m_notes, failure);
}

std::uint64_t KeptRows::takeUp(std::string_view notes) {
    std::error_code error;
    const std::uint64_t there = std::filesystem::file_size(m_path, error);
    std::uint64_t read = 0;
    for (std::size_t end = 0; !error && (end = notes.find('\n', read)) != notes.npos; read = end + 1) {
        const std::optional<RowsDone> done = readNote(notes.substr(read, end - read));
        if (!done || done->sum.bytes > there) break;
        m_done = *done;
    }
    if (sumOfStart(m_path, m_done.sum.bytes) == m_done.sum) return read;
    m_done = {};
    return 0;
}

WriteFailure KeptRows::note(const RowsDone& done) {
    const auto now = std::chrono::steady_clock::now();
    return now < m_next ? WriteFailure{} : noteNow(done);
}

WriteFailure KeptRows::noteNow(const RowsDone& done) {
    m_next = std::chrono::steady_clock::now() + betweenNotes;
    return writeAll(m_descriptor, noteOf(done));
}

void KeptRows::remove() {
    ::unlink(m_notes.c_str());
}

}  // namespace drillwave
