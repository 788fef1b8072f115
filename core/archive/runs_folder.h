// SPDX-License-Identifier: GPL-3.0-or-later
// The folder of kept runs, and which of its files are ours.
#pragma once

#include <string>
#include <vector>

#include "core/disk/whole_folder.h"

namespace drillwave {

/// Files that were read here or written count as ours while they stay as they were; any other one of a name
/// of ours is foreign. A value: a copy of it may be written on another thread.
class RunsFolder {
  public:
    RunsFolder() = default;
    explicit RunsFolder(std::string path) : m_path(std::move(path)) {}

    /// Empty where there is no scenario file, beside which it would be.
    const std::string& path() const { return m_path; }
    /// What is there under the names of these files is ours, as it is.
    void adopt(const std::vector<NamedFile>& named);
    bool hasFiles() const { return !m_files.empty(); }
    /// Whether these are the files that were read or written, as far as is known here.
    bool holds(const std::vector<NamedFile>& files) const;
    /// The path of the first foreign file that writing these would replace or remove; empty where none is.
    std::string foreignFile(const std::vector<NamedFile>& files) const;
    /// The numbers of runs whose files are there and not ours.
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
