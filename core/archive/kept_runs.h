// SPDX-License-Identifier: GPL-3.0-or-later
// Runs kept in a folder beside their scenario file (files §9): a scenario a run, and an index of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/disk/whole_folder.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {

/// Runs have letters, by which their files are called: A.yaml, B.yaml …
inline constexpr int mostRuns = 12;

/// "A" for 0, the next for the next.
std::string runLetter(int number);

/// "A.yaml" for 0.
std::string runFileName(int number);

/// Kept run: everything needed to solve it again.
struct KeptRun {
    int number = 0;             ///< 0 … mostRuns − 1, of its letter
    std::string name;           ///< "k 300 MN/m"
    ScenarioDocument contents;  ///< `text` is the file byte for byte
    bool isShown = true;        ///< laid over the plots
    bool isReference = false;   ///< that others are compared with
    std::optional<double> cor;  ///< as it was solved; tells a table of the blow that has changed since
    std::string version = {};   ///< of the program that solved it; empty where the index does not say
};

/// Contents of a folder of runs.
struct KeptRuns {
    std::vector<KeptRun> runs;
    std::vector<std::string> problems;  ///< one line each, on runs that could not be taken
    std::vector<int> foreign;           ///< numbers whose files are there, but not among `runs`: not to be
                                        ///< written over
};

/// "t38.runs" beside "t38.yaml", "t38.yml.runs" beside "t38.yml", "t38.scenario.runs" beside "t38": no two
/// files have the same one.
std::string runsFolderOf(const std::string& scenarioPath);

/// The files of the folder: the scenarios and, last, the index.
std::vector<NamedFile> runFiles(const std::vector<KeptRun>& runs);

/// The runs of a folder; none and no problem where it is not there. A table of the blow is read relative to
/// the scenario file, as for the scenario itself.
KeptRuns readRuns(const std::string& folder, const std::string& scenarioPath);

// The folder of kept runs, and which of its files are ours.

/// Files that were read here or written count as ours while they stay as they were; any other one of a name
/// of ours is foreign. A value: a copy of it may be written on another thread.
class RunsFolder {
  public:
    RunsFolder() = default;
    explicit RunsFolder(std::string path) : m_path(std::move(path)) {}

    /// Empty if there is no scenario file to put the folder beside.
    const std::string& path() const { return m_path; }
    /// Takes the files of these names as ours, as they are on the disk.
    void adopt(const std::vector<NamedFile>& named);
    bool hasFiles() const { return !m_files.empty(); }
    /// Returns whether these files are the ones read or written, as far as known here.
    bool holds(const std::vector<NamedFile>& files) const;
    /// Returns the path of the first foreign file that writing these would replace or remove; empty if none.
    std::string foreignFile(const std::vector<NamedFile>& files) const;
    /// Returns the numbers of runs whose files exist and are not ours.
    std::vector<int> foreignNumbers() const;

    /// Writes the files, the index of them last, whole or not at all, and removes those of ours that are not
    /// among them. Foreign ones are replaced only if that is asked for. Returns why not. Waits for the disk.
    Message write(const std::vector<NamedFile>& files, ExistingFiles existing);
    /// Takes the files that are ours away, and the folder where nothing else is in it.
    void remove();

  private:
    std::string pathOf(const std::string& name) const { return m_path + "/" + name; }
    bool isForeign(const std::string& name) const;
    std::vector<NamedFile> unwritten(const std::vector<NamedFile>& files) const;

    std::string m_path;
    std::vector<NamedFile> m_files;  // that are ours, as they are there
};

}  // namespace drillwave
