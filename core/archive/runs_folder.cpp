// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/archive/runs_folder.h"

#include <algorithm>
#include <filesystem>

#include "core/archive/kept_runs.h"
#include "core/disk/file_bytes.h"
#include "core/yaml/scenario_reader.h"

namespace drillwave {

void RunsFolder::adopt(const std::vector<NamedFile>& named) {
    m_files.clear();
    for (const NamedFile& file : named) {
        FileBytes found = readFile(pathOf(file.name), maximumScenarioBytes);
        if (found.problem.isEmpty()) m_files.push_back({file.name, std::move(found.bytes)});
    }
}

bool RunsFolder::holds(const std::vector<NamedFile>& files) const {
    return std::ranges::equal(m_files, files, [](const NamedFile& one, const NamedFile& other) {
        return one.name == other.name && one.bytes == other.bytes;
    });
}

bool RunsFolder::isForeign(const std::string& name) const {
    if (!isThere(pathOf(name))) return false;
    const auto ours = std::ranges::find(m_files, name, &NamedFile::name);
    const FileBytes found = readFile(pathOf(name), maximumScenarioBytes);
    return ours == m_files.end() || !found.problem.isEmpty() || found.bytes != ours->bytes;
}

std::string RunsFolder::foreignFile(const std::vector<NamedFile>& files) const {
    std::vector<std::string> names = FolderFiles{files, {}}.names();
    for (const NamedFile& file : m_files) names.push_back(file.name);
    const auto found = std::ranges::find_if(names, [this](const auto& name) { return isForeign(name); });
    return found == names.end() ? std::string() : pathOf(*found);
}

std::vector<int> RunsFolder::foreignNumbers() const {
    std::vector<int> numbers;
    for (int number = 0; number < mostRuns; ++number) {
        const std::string name = runFileName(number);
        const bool isOurs = std::ranges::find(m_files, name, &NamedFile::name) != m_files.end();
        if (!isOurs && isThere(pathOf(name))) numbers.push_back(number);
    }
    return numbers;
}

// The disk is waited for with every file. The index, which is last, tells that the folder is complete.
std::vector<NamedFile> RunsFolder::unwritten(const std::vector<NamedFile>& files) const {
    std::vector<NamedFile> left = files;
    std::erase_if(left, [&](const NamedFile& file) {
        const auto ours = std::ranges::find(m_files, file.name, &NamedFile::name);
        const bool isWritten = ours != m_files.end() && ours->bytes == file.bytes;
        return isWritten && file.name != files.back().name && isThere(pathOf(file.name));
    });
    return left;
}

Message RunsFolder::write(const std::vector<NamedFile>& files, ExistingFiles existing) {
    const bool keeps = existing == ExistingFiles::kept;
    if (std::string foreign = keeps ? foreignFile(files) : std::string(); !foreign.empty())
        return {
            translatable(
                "%1: has been put there or changed by somebody else; move it away, or keep the runs again to "
                "replace it"),
            {std::move(foreign)}};
    FolderFiles folder{keeps ? unwritten(files) : files, {}};
    std::vector<std::string> outdated;
    const std::vector<std::string> names = FolderFiles{files, {}}.names();
    for (const NamedFile& file : m_files)
        if (std::ranges::find(names, file.name) == names.end()) outdated.push_back(file.name);
    folder.outdated = [outdated](const std::string&) { return outdated; };
    FolderEnd end = writeWholeFolder(m_path, folder, ExistingFiles::replaced);
    if (end.isWritten()) m_files = files;
    return std::move(end.problem);
}

void RunsFolder::remove() {
    std::error_code ignored;  // what stays is seen in the folder
    for (const NamedFile& file : m_files)
        if (!isForeign(file.name)) std::filesystem::remove(pathOf(file.name), ignored);
    std::filesystem::remove(pathOf(".drillwave.lock"), ignored);
    if (std::filesystem::is_directory(m_path, ignored)) std::filesystem::remove(m_path, ignored);
    m_files.clear();
}

}  // namespace drillwave
