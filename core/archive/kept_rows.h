// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of a run that may end before its time, kept beside their file so that the same run can go on behind
// them.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "core/disk/file_bytes.h"
#include "core/disk/whole_file.h"
#include "core/text/message.h"

namespace drillwave {

/// Progress of a run of rows.
struct RowsDone {
    std::uint64_t rows = 0;
    std::uint64_t unsolved = 0;  ///< of these
    FileSum sum;                 ///< of their file, with its header
    bool operator==(const RowsDone&) const = default;
};

/// Two files on the way to FILE: FILE.partial with the rows, and FILE.partial.yaml, which says what they are
/// and how far the run came. Held by one process at a time.
class KeptRows {
  public:
    /// Whether rows of another run are a problem or make room.
    enum class Other { isProblem, isReplaced };

    /// Continues the run with the same `entries` (recordEntries()) that was left there, or begins.
    KeptRows(const std::string& file, const std::string& entries, Other other);
    ~KeptRows();
    KeptRows(const KeptRows&) = delete;
    KeptRows& operator=(const KeptRows&) = delete;

    /// Why there is nothing to go on with: another run's rows, another process, a disk; empty otherwise.
    const Message& problem() const { return m_problem; }
    /// Returns the path of the rows.
    const std::string& path() const { return m_path; }
    /// Returns the progress of the run; later bytes of the file are not valid.
    const RowsDone& done() const { return m_done; }

    /// Notes how far the run is, from time to time: what is in the file then must have been written.
    WriteFailure note(const RowsDone& done);
    /// Notes it now.
    WriteFailure noteNow(const RowsDone& done);
    /// Removes what says how far the run came, when the rows are in their place.
    void remove();

  private:
    void open(const std::string& entries, Other other);
    /// Reads the notes of the run before and returns how many of their bytes hold.
    std::uint64_t takeUp(std::string_view notes);

    std::string m_path;
    std::string m_notes;  // the path of FILE.partial.yaml
    Message m_problem;
    RowsDone m_done;
    int m_descriptor = -1;
    std::chrono::steady_clock::time_point m_next;
};

}  // namespace drillwave
