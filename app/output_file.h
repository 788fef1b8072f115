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

/// Throws CommandError (usage) if one of `options` is given without -o. These options, such as --force, apply
/// only to output files. The message suggests -o with `output`, for example "-o FILE.csv".
void checkAboutFiles(const Arguments& arguments, std::initializer_list<const char*> options,
                     const char* output);

/// Returns the description of the option --decimal-comma, for commands that write CSV.
OptionSpec decimalCommaSpec();
/// Chooses decimal commas and semicolons for all CSV that this run of the program writes, if --decimal-comma
/// is given.
void useCsvSigns(const Arguments& arguments);
/// Returns a complete CSV text, converted to decimal commas and semicolons if --decimal-comma is given.
std::string inCsvSigns(std::string_view csv);
/// Returns the contents of a file to be written. CSV files are converted to decimal commas and semicolons if
/// --decimal-comma is given.
std::string bytesInSigns(const NamedFile& file);

/// Function that returns the names of existing files in `folder` that an earlier run wrote together with
/// `file`, such as pictures.
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

/// Throws CommandError (unwritable output) if the file `path`, or an existing file that belongs to it, may
/// not be replaced. Before that, completes or undoes changes that a crashed run has left unfinished in the
/// folder.
void checkOutput(const std::string& path, Overwrite overwrite, LeftBeside leftBeside = studyFilesThere);

/// Output of a command: a file, or standard output. All functions throw CommandError (unwritable output) on
/// failure. The constructor already throws if it can detect the failure.
class OutputFile {
  public:
    /// Opens an output. Standard output, devices and pipes are written directly. A file is first written
    /// under a temporary name; commit() gives it its final name.
    OutputFile(const std::string& path, Overwrite overwrite, LeftBeside leftBeside = studyFilesThere);
    /// Opens an output file that continues the rows of an interrupted run, stored in the temporary file of
    /// `kept`. Without commit(), the rows stay in the temporary file, so that a later run can continue them.
    OutputFile(const std::string& path, Overwrite overwrite, const KeptRows& kept);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Writes complete lines of CSV. With --decimal-comma, converts them to decimal commas and semicolons.
    void write(std::string_view csv);
    /// Writes a text as it is, without the conversion of decimal signs that write() does.
    void writeText(std::string_view text);
    /// Returns size and checksum of everything written so far, including rows kept from an interrupted run.
    const FileSum& sum() const { return m_sum; }
    /// Adds a file, such as a picture, to be written together with this one in the same folder. Requires that
    /// this output is a file, not a stream.
    void add(NamedFile beside);
    /// Gives this file and those of add() their final names together (see writeWholeFolder()); they replace
    /// files of an earlier run. For a stream, only checks that all bytes were written. Throws CommandError
    /// (interrupted) if a stop was requested before.
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
