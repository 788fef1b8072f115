// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of an interrupted run, kept next to their file so that the same run can continue after them.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "core/disk/file_bytes.h"
#include "core/disk/whole_file.h"
#include "core/text/message.h"

namespace drillwave {

/// Progress of a sweep or table whose result rows are written to a CSV file. An interrupted run continues
/// from here.
struct RowsDone {
    std::uint64_t rows = 0;
    std::uint64_t unsolved = 0;  ///< number of rows for which no result was found
    FileSum sum;                 ///< size and checksum of the file of rows, including its header
    bool operator==(const RowsDone&) const = default;
};

/// Two temporary files of a run that writes result rows to a CSV file: FILE.partial with the rows,
/// FILE.partial.yaml with their description and progress. An interrupted run can continue from them. Only one
/// process at a time can use them.
class KeptRows {
  public:
    /// Treatment of temporary files that contain rows of another run: report a problem, or overwrite them.
    enum class Other { isProblem, isReplaced };

    /// Continues the interrupted run that writes the CSV file `file`, if it has the same description
    /// `entries` (recordEntries()). Otherwise begins a new run. `other` decides what happens to rows of a
    /// different run.
    KeptRows(const std::string& file, const std::string& entries, Other other);
    ~KeptRows();
    KeptRows(const KeptRows&) = delete;
    KeptRows& operator=(const KeptRows&) = delete;

    /// Returns why the run can neither continue nor begin: the files belong to another run, another process
    /// uses them, or the disk fails. Empty if it can.
    const Message& problem() const { return m_problem; }
    /// Returns the path of FILE.partial, which contains the rows.
    const std::string& path() const { return m_path; }
    /// Returns the progress of the interrupted run that this run continues; no rows for a new run.
    /// FILE.partial may have more bytes than RowsDone::sum counts; the further ones are not valid.
    const RowsDone& done() const { return m_done; }

    /// Writes the progress to FILE.partial.yaml, but at most every 200 ms. All rows counted in `done` must
    /// already be in FILE.partial. Returns an empty failure when done or skipped.
    WriteFailure note(const RowsDone& done);
    /// Writes the progress to FILE.partial.yaml at once, while note() may skip it. Returns an empty failure
    /// when done.
    WriteFailure noteNow(const RowsDone& done);
    /// Removes FILE.partial.yaml, which holds the description and progress of the rows. Call it after the
    /// rows have been moved to their final file.
    void remove();

  private:
    void open(const std::string& entries, Other other);
    /// Sets the progress to the last valid one in `notes`, the text of FILE.partial.yaml after its
    /// description. If the beginning of FILE.partial has another checksum, no rows are kept. Returns the
    /// number of valid bytes of `notes`.
    std::uint64_t takeUp(std::string_view notes);

    std::string m_path;
    std::string m_notes;  // path of FILE.partial.yaml
    Message m_problem;
    RowsDone m_done;
    int m_descriptor = -1;
    std::chrono::steady_clock::time_point m_next;
};

}  // namespace drillwave
