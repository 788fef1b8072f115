// SPDX-License-Identifier: GPL-3.0-or-later
// Outputs of a command: standard output, or a file that appears whole or not at all, together with the files
// that belong to it.
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

/// Throws CommandError (usage) if one of the options is given without the -o whose files it concerns;
/// `output` is the name to add, "FILE.csv".
void checkAboutFiles(const Arguments& arguments, std::initializer_list<const char*> options,
                     const char* output);

/// --decimal-comma, for the options of a command that writes CSV.
OptionSpec decimalCommaSpec();
/// Sets the signs of all CSV in this run of the program from its option.
void useCsvSigns(const Arguments& arguments);
/// Returns whole CSV in the signs of this run.
std::string inCsvSigns(std::string_view csv);
/// Returns the bytes of a file, CSV in the signs of this run.
std::string bytesInSigns(const NamedFile& file);

/// Returns the names of files that an earlier run left in the folder beside a file.
using LeftBeside = std::vector<std::string> (*)(const std::string& folder, const std::string& file);

/// Whether a name is standard output, a device or a pipe: written to directly, with no files beside it.
bool isStream(const std::string& path);

/// Throws CommandError (unwritable output) where standard output is closed: for commands that print when
/// their files are in place.
void checkStandardOutput();

/// Throws CommandError (unwritable output) for a name with bytes that are not UTF-8: records and messages
/// could not contain it.
void checkName(const std::string& path);

/// Throws CommandError (unwritable output) when a file of that name exists and may not be overwritten.
void checkOverwrite(const std::string& path, Overwrite overwrite);

/// Checks a file and those left beside it, after repairing what a run that died has left in the folder.
void checkOutput(const std::string& path, Overwrite overwrite, LeftBeside leftBeside = studyFilesThere);

/// One output. All failures throw CommandError (unwritable output), at opening if they can be known
/// then.
class OutputFile {
  public:
    /// A stream is written directly. Anything else has no name until commit().
    OutputFile(const std::string& path, Overwrite overwrite, LeftBeside leftBeside = studyFilesThere);
    /// Continues after the rows that are kept for this file, and keeps them if it is not committed.
    OutputFile(const std::string& path, Overwrite overwrite, const KeptRows& kept);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Writes whole lines where the file is CSV.
    void write(std::string_view text);
    /// Size and checksum of all that was written, the kept rows included.
    const FileSum& sum() const { return m_sum; }
    /// Adds a file beside this one, which must be no stream.
    void add(NamedFile beside);
    /// Writes everything as one (writeWholeFolder()) and replaces what was left beside the file; for a
    /// stream, finds out whether everything has found room. Throws CommandError (interrupted) on a stop.
    void commit(const Interruption* interruption = nullptr);

  private:
    /// Finds out whether everything written to standard output so far has found room.
    void flush();
    /// Throws where there is a failure.
    void check(const WriteFailure& failure) const;

    std::string m_path;
    Overwrite m_overwrite;
    LeftBeside m_leftBeside;
    std::unique_ptr<WholeFile> m_file;  // none for streams
    CsvInSigns m_csv;                   // signs of this run
    FileSum m_sum;
    std::vector<NamedFile> m_beside;
    int m_device = -1;
};

/// Prints a text to standard output at once, as printableLines().
void printText(std::string_view text);

}  // namespace drillwave
