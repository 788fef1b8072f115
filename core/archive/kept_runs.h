// SPDX-License-Identifier: GPL-3.0-or-later
// Runs that are kept in a folder next to their scenario file (files §9): a scenario for each run, and an
// index.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/disk/whole_folder.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {

/// Largest number of pinned runs (results kept for comparison). Each has a letter, which is the name of its
/// file: A.yaml, B.yaml, …
inline constexpr int mostRuns = 12;

/// Returns the letter by which the user knows the pinned run with this number: "A" for 0, "B" for 1.
std::string runLetter(int number);

/// Returns the name of the scenario file of the pinned run with this number: "A.yaml" for 0.
std::string runFileName(int number);

/// Pinned run: a result kept for comparison, with everything that is needed to solve it again.
struct KeptRun {
    int number = 0;             ///< number of the run, 0 … mostRuns − 1, from which its letter follows
    std::string name;           ///< name given by the user, "k 300 MN/m"
    ScenarioDocument contents;  ///< scenario of the run; `text` in it equals the run's file byte for byte
    bool isShown = true;        ///< whether the curves of the run are drawn in the plots
    bool isReference = false;   ///< whether the present result and other runs are compared with this run
    /// Coefficient of restitution e of the run. It shows whether the table file of the hammer force has
    /// changed: solving the run again then gives another e.
    std::optional<double> cor;
    /// Version of the program that solved the run; empty if the index file does not give it.
    std::string version = {};
};

/// Contents of a folder of pinned runs (results kept for comparison).
struct KeptRuns {
    std::vector<KeptRun> runs;
    std::vector<std::string> problems;  ///< messages on runs that could not be read, one line each
    /// Numbers of runs whose files exist in the folder but could not be read or are not listed in the index
    /// file. These files must not be overwritten.
    std::vector<int> foreign;
};

/// Returns the folder for the pinned runs of a scenario file, different for every file: "t38.runs" for
/// "t38.yaml", "t38.yml.runs" for "t38.yml", "t38.scenario.runs" for "t38".
std::string runsFolderOf(const std::string& scenarioPath);

/// Returns the files for a folder of pinned runs: one scenario file per run and, last, the index file.
std::vector<NamedFile> runFiles(const std::vector<KeptRun>& runs);

/// Returns the pinned runs stored in a folder; none and no problem if the folder does not exist. The relative
/// path of a force table starts at the folder of the scenario file.
KeptRuns readRuns(const std::string& folder, const std::string& scenarioPath);

// Folder of kept runs, and which of its files this program has written.

/// Folder of pinned runs (results kept for comparison). The object remembers names and contents of the files
/// that it has read or written. A file of a run is foreign if it is not one of these, or if its contents have
/// changed since. Copies may be used on another thread.
class RunsFolder {
  public:
    RunsFolder() = default;
    explicit RunsFolder(std::string path) : m_path(std::move(path)) {}

    /// Returns the path of the folder of pinned runs; empty if the scenario has no file.
    const std::string& path() const { return m_path; }
    /// Treats the files with these names as files of this program, which it may replace. Reads their present
    /// contents from the disk and remembers them, to notice later changes by others. Forgets all other files.
    void adopt(const std::vector<NamedFile>& named);
    bool hasFiles() const { return !m_files.empty(); }
    /// Returns whether `files` are exactly the files that this object has read or written, with the same
    /// names and bytes. Then nothing needs to be written. Does not read the disk.
    bool holds(const std::vector<NamedFile>& files) const;
    /// Returns the path of the first foreign file that writing these files would replace or remove. A foreign
    /// file is one that this object has neither read nor written, or that has changed since. Empty if there
    /// is none.
    std::string foreignFile(const std::vector<NamedFile>& files) const;
    /// Returns the numbers of pinned runs whose files exist in the folder but were not read or written by
    /// this object. New runs must not use these numbers.
    std::vector<int> foreignNumbers() const;

    /// Writes all files of the pinned runs, the index last: all or none. Removes files of earlier runs that
    /// are not in `files`. Foreign files are replaced only with ExistingFiles::replaced; otherwise they are a
    /// problem. Returns an empty message when done, else the problem. Waits until the files are on the disk.
    Message write(const std::vector<NamedFile>& files, ExistingFiles existing);
    /// Removes the files that this object has read or written, except files that others have changed since.
    /// Removes the folder too if nothing else is in it.
    void remove();

  private:
    std::string pathOf(const std::string& name) const { return m_path + "/" + name; }
    bool isForeign(const std::string& name) const;
    std::vector<NamedFile> unwritten(const std::vector<NamedFile>& files) const;

    std::string m_path;
    std::vector<NamedFile> m_files;  // files read or written here, with their contents
};

}  // namespace drillwave
