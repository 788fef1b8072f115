// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/input_text.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <system_error>

#include "app/command_error.h"
#include "core/disk/file_bytes.h"
#include "core/disk/whole_file.h"

namespace drillwave {

namespace {

std::string reason(int error) {
    return std::generic_category().message(error);
}

/// Something that is read once, from its beginning to its end.
class Pipe {
  public:
    Pipe(const std::string& path, const ReadingStyle& style)
        : m_isOwn(!isStandardInput(path)),
          m_descriptor(m_isOwn ? ::open(path.c_str(), O_RDONLY | O_CLOEXEC) : STDIN_FILENO) {
        if (m_descriptor < 0) m_problem = cannotBeOpened(reason(errno));
        if (!m_isOwn && ::isatty(STDIN_FILENO) == 1)
            std::fprintf(stderr, "%s\n",
                         style.said(translatable("reading standard input; end it with Ctrl-D")).c_str());
    }
    ~Pipe() {
        if (m_isOwn && m_descriptor >= 0) ::close(m_descriptor);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    /// Up to `most` of the next bytes; 0 at the end and where there is a problem().
    std::size_t read(char* bytes, std::size_t most) {
        while (m_problem.isEmpty()) {
            const ssize_t got = ::read(m_descriptor, bytes, most);
            if (got >= 0) return static_cast<std::size_t>(got);
            if (errno != EINTR) m_problem = {translatable("cannot be read: %1"), {reason(errno)}};
        }
        return 0;
    }
    const Message& problem() const { return m_problem; }

  private:
    bool m_isOwn;
    int m_descriptor;
    Message m_problem;
};

/// Standard input, a pipe or a terminal: what can be read only once.
bool isPipe(const std::string& path) {
    struct stat status {};
    if (isStandardInput(path)) return true;
    if (::stat(path.c_str(), &status) != 0) return false;
    return S_ISFIFO(status.st_mode) || S_ISCHR(status.st_mode) || S_ISSOCK(status.st_mode);
}

std::string temporaryFolder() {
    const char* chosen = std::getenv("TMPDIR");
    return chosen && *chosen != '\0' ? chosen : "/tmp";
}

/// A file whose name goes with this object.
struct TemporaryFile {
    std::string name = temporaryFolder() + "/drillwave-rows-XXXXXX";
    int descriptor = ::mkstemp(name.data());  ///< negative where it cannot be made

    TemporaryFile() = default;
    ~TemporaryFile() {
        if (descriptor < 0) return;
        ::close(descriptor);
        ::unlink(name.c_str());
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
};

constexpr std::size_t chunkBytes = std::size_t{1} << 16;

}  // namespace

bool isStandardInput(const std::string& path) {
    return path == "-";
}

std::string inputName(const std::string& path) {
    return isStandardInput(path) || path == "/dev/stdin" ? "standard input" : path;
}

FileBytes readInput(const std::string& path, std::size_t most, const ReadingStyle& style) {
    if (!isPipe(path)) return readStart(path, most);
    Pipe pipe(path, style);
    std::string bytes;
    std::array<char, chunkBytes> chunk{};
    while (bytes.size() < most) {
        const std::size_t got = pipe.read(chunk.data(), std::min(chunk.size(), most - bytes.size()));
        if (got == 0) break;
        bytes.append(chunk.data(), got);
    }
    if (!pipe.problem().isEmpty()) return {{}, pipe.problem()};
    return {std::move(bytes), {}};
}

RereadableInput::Buffer::int_type RereadableInput::Buffer::underflow() {
    try {
        return std::filebuf::underflow();
    } catch (const std::ios_base::failure& failure) {
        throw CommandError(
            ExitCode::unreadableInput,
            Message(translatable("%1: cannot be read: %2; copy it to another disk, or get it again"),
                    {m_name, failure.code().message()}));
    }
}

RereadableInput::RereadableInput(const std::string& path, std::uint64_t most, const ReadingStyle& style)
    : m_buffer(inputName(path)) {
    const auto refuse = [&](const Message& problem) {
        throw CommandError(ExitCode::unreadableInput, about(inputName(path), problem));
    };
    if (isPipe(path)) {
        keep(path, most, style);
        return;
    }
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) refuse(cannotBeOpened(reason(errno)));
    if (!S_ISREG(status.st_mode))
        refuse(translatable("is not a regular file; save the rows to a file first"));
    if (!m_buffer.open(path, std::ios::in | std::ios::binary))
        refuse(translatable("cannot be opened for reading; check its permissions"));
}

void RereadableInput::keep(const std::string& path, std::uint64_t most, const ReadingStyle& style) {
    const TemporaryFile kept;
    const auto refuse = [&](const std::string& problem) {
        throw CommandError(
            ExitCode::unwritableOutput,
            Message(translatable("%1: cannot be stored in %2: %3; set TMPDIR to a folder with more space"),
                    {inputName(path), temporaryFolder(), problem}));
    };
    if (kept.descriptor < 0) refuse(reason(errno));
    Pipe pipe(path, style);
    std::array<char, chunkBytes> chunk{};
    std::uint64_t bytes = 0;
    while (const std::size_t got = pipe.read(chunk.data(), chunk.size())) {
        bytes += got;
        if (bytes > most)
            throw CommandError(ExitCode::unreadableInput,
                               Message(translatable("%1: is longer than %2 MiB, the limit for input that is "
                                                    "not a file; save its rows to a file first"),
                                       {inputName(path), std::to_string(most >> 20)}));
        if (const WriteFailure failure = writeAll(kept.descriptor, {chunk.data(), got}))
            refuse(failure.reason);
    }
    if (!pipe.problem().isEmpty())
        throw CommandError(ExitCode::unreadableInput, about(inputName(path), pipe.problem()));
    // The name goes at once, the rows when the stream is closed: nothing can be left behind.
    if (!m_buffer.open(kept.name, std::ios::in | std::ios::binary)) refuse(reason(errno));
}

}  // namespace drillwave
