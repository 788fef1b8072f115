// SPDX-License-Identifier: GPL-3.0-or-later
// Outputs of a command: standard output, or a file that is written completely or not at all, together with
// the files beside it.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/arguments.h"
#include "core/archive/kept_rows.h"
#include "core/archive/result_files.h"
#include "core/disk/file_bytes.h"
#include "core/disk/whole_file.h"
#include "core/disk/whole_folder.h"
#include "core/text/csv.h"

namespace drillwave {

class Interruption;

enum class Overwrite { refused, allowed };

/// Throws CommandError (usage) if one of `options`, which apply only to files, is given without -o. The
/// message suggests adding `output`, for example "FILE.csv".
void checkAboutFiles(const Arguments& arguments, std::initializer_list<const char*> options,
                     const char* output);

/// Returns the option --decimal-comma, for commands that write CSV.
OptionSpec decimalCommaSpec();
/// Sets the decimal sign and separator of all CSV that this run of the program writes, from --decimal-comma.
void useCsvSigns(const Arguments& arguments);
/// Returns a complete CSV text with the decimal sign and separator of this run.
std::string inCsvSigns(std::string_view csv);
/// Returns the contents of a file; CSV files have the decimal sign and separator of this run.
std::string bytesInSigns(const NamedFile& file);

/// Function that returns the names of files that an earlier run left in `folder` and that belong to `file`,
/// such as pictures.
using LeftBeside = std::vector<std::string> (*)(const std::string& folder, const std::string& file);

/// Returns true if a path is standard output, a device or a pipe, which are written directly and have no
/// files beside them.
bool isStream(const std::string& path);

/// Throws CommandError (unwritable output) if standard output is closed. For commands that print only after
/// their files are written.
void checkStandardOutput();

/// Throws CommandError (unwritable output) if a path is not valid UTF-8, because records and messages could
/// not contain it.
void checkName(const std::string& path);

/// Throws CommandError (unwritable output) if `path` cannot be the name of a file, or if the file exists and
/// `overwrite` does not allow replacing it.
void checkOverwrite(const std::string& path, Overwrite overwrite);

/// Throws CommandError (unwritable output) if a file, or an existing file that belongs to it, may not be
/// replaced. First repairs what a crashed run left in the folder.
void checkOutput(const std::string& path, Overwrite overwrite, LeftBeside leftBeside = studyFilesThere);

/// Output of a command. All functions throw CommandError (unwritable output) on failure, the constructor
/// already if the failure can be known then.
class OutputFile {
  public:
    /// Opens an output. Standard output, devices and pipes are written directly; a file appears under its
    /// name only with commit().
    OutputFile(const std::string& path, Overwrite overwrite, LeftBeside leftBeside = studyFilesThere);
    /// Opens a file and continues after the rows in `kept`, which an interrupted run has written. Without
    /// commit() the rows stay there for a later run.
    OutputFile(const std::string& path, Overwrite overwrite, const KeptRows& kept);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Writes complete lines of CSV, with the decimal sign and separator of this run.
    void write(std::string_view csv);
    /// Writes a text as it is.
    void writeText(std::string_view text);
    /// Returns size and checksum of everything written so far, including rows kept from an interrupted run.
    const FileSum& sum() const { return m_sum; }
    /// Adds a file to be written beside this one. Requires that this output is a file, not a stream.
    void add(NamedFile beside);
    /// Puts this file and the added ones in place together (writeWholeFolder()), replacing files of an
    /// earlier run. For a stream, checks that all bytes were written. Throws CommandError (interrupted) on a
    /// stop.
    void commit(const Interruption* interruption = nullptr);

  private:
    /// Flushes standard output and throws CommandError if its last bytes could not be written.
    void flush();
    /// Throws CommandError (unwritable output) if `failure` has a reason; does nothing if it is empty.
    void check(const WriteFailure& failure) const;

    std::string m_path;
    Overwrite m_overwrite;
    LeftBeside m_leftBeside;
    std::unique_ptr<WholeFile> m_file;  // file being written; nullptr for streams
    CsvInSigns m_csv;                   // rewrites CSV with the decimal sign and separator of this run
    FileSum m_sum;
    std::vector<NamedFile> m_beside;
    int m_device = -1;
};

/// Prints a text to standard output at once. Characters that terminals would interpret are made visible, see
/// printableLines().
void printText(std::string_view text);

}  // namespace drillwave
