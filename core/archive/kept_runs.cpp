// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/archive/kept_runs.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "core/disk/file_bytes.h"
#include "core/text/csv.h"
#include "core/text/decimal_text.h"
#include "core/text/units.h"
#include "core/yaml/scenario_reader.h"

namespace drillwave {

namespace {

constexpr char indexName[] = "runs.csv";
constexpr char indexHeader[] = "file,name,shown,reference,cor,version";
constexpr std::size_t indexColumns = 6, oldIndexColumns = 5;
constexpr std::size_t maximumIndexBytes = std::size_t{1} << 16;
constexpr char ending[] = ".yaml";

/// The number of a file's letter; nothing where it is no file of a run.
std::optional<int> numberOf(const std::string& file) {
    for (int number = 0; number < mostRuns; ++number)
        if (file == runFileName(number)) return number;
    return std::nullopt;
}

std::string nameOf(const std::filesystem::path& folder) {
    return folder.filename().string();
}

class RunsReader {
  public:
    RunsReader(std::string folder, std::string scenarioPath)
        : m_folder(std::move(folder)), m_scenarioPath(std::move(scenarioPath)) {}

    KeptRuns read() {
        const FileBytes index = readFile(m_folder + "/" + indexName, maximumIndexBytes);
        if (index.problem.isEmpty())
            readIndex(index.bytes);
        else
            refuse(indexName, index.problem.text() + "; the runs in this folder are not shown");
        for (int number = 0; number < mostRuns; ++number)
            if (isThere(m_folder + "/" + runFileName(number)) && !has(number))
                m_kept.foreign.push_back(number);
        return std::move(m_kept);
    }

  private:
    void readIndex(const std::string& bytes) {
        std::istringstream in(bytes);
        CsvReader reader(in, maximumIndexBytes);
        CsvRecord record;
        bool isHeader = true;
        while (reader.next(record)) {
            if (std::exchange(isHeader, false)) continue;
            const std::string place = std::string(indexName) + ":" + std::to_string(reader.line());
            if (!record.problem.isEmpty())
                return refuse(place, record.problem.text() + "; this run and those below are left out");
            readRow(place, record.cells);
        }
    }

    void readRow(const std::string& place, const std::vector<std::string>& cells) {
        if (cells.size() != indexColumns && cells.size() != oldIndexColumns)
            return refuse(place, "has " + std::to_string(cells.size()) + " cells instead of " + indexHeader +
                                     "; this run is left out");
        const std::optional<int> number = numberOf(cells[0]);
        if (!number || has(*number))
            return refuse(place, "`" + shortened(cells[0]) +
                                     "` is not the file of a run (A.yaml, B.yaml, …), or the second "
                                     "row of it; this run is left out");
        const FileBytes file = readFile(m_folder + "/" + cells[0], maximumScenarioBytes);
        if (!file.problem.isEmpty()) return refuse(cells[0], file.problem.text() + "; this run is left out");
        try {
            m_kept.runs.push_back({.number = *number,
                                   .name = cells[1],
                                   .contents = parseScenario(file.bytes, m_scenarioPath),
                                   .isShown = cells[2] != "no",
                                   .isReference = cells[3] == "yes",
                                   .cor = parseNumber(cells[4]),
                                   .version = cells.size() == indexColumns ? cells[5] : std::string()});
        } catch (const ScenarioError& error) {
            // The text is not the scenario's, by which its tables are found.
            const ScenarioError here(error.kind(), cells[0], error.problems());
            refuse({}, here.lines().front() + "; this run is left out");
        }
    }

    bool has(int number) const {
        return std::ranges::find(m_kept.runs, number, &KeptRun::number) != m_kept.runs.end();
    }

    void refuse(const std::string& place, const std::string& reason) {
        m_kept.problems.push_back(nameOf(m_folder) + "/" + place + (place.empty() ? "" : ": ") + reason);
    }

    std::string m_folder;
    std::string m_scenarioPath;
    KeptRuns m_kept;
};

}  // namespace

std::string runLetter(int number) {
    return std::string(1, static_cast<char>('A' + number));
}

std::string runFileName(int number) {
    return runLetter(number) + ending;
}

// "t38.yaml" has the short name. Any other name keeps its ending, or is given one where it has none that a
// scenario is known by; and what would be mistaken for one of those without its ".yaml" keeps that.
std::string runsFolderOf(const std::string& scenarioPath) {
    constexpr char otherEnding[] = ".scenario";
    const auto isEndingOfOthers = [&](const std::filesystem::path& extension) {
        return extension == ".yml" || extension == ".json";
    };
    const std::filesystem::path path(scenarioPath);
    if (path.extension() == ending) {
        const std::filesystem::path inner = path.stem().extension();
        const bool isMistaken = isEndingOfOthers(inner) || inner == ending || inner == otherEnding;
        return (isMistaken ? path : path.parent_path() / path.stem()).string() + ".runs";
    }
    return path.string() + (isEndingOfOthers(path.extension()) ? "" : otherEnding) + ".runs";
}

std::vector<NamedFile> runFiles(const std::vector<KeptRun>& runs) {
    std::vector<NamedFile> files;
    std::string index = std::string(indexHeader) + '\n';
    for (const KeptRun& run : runs) {
        files.push_back({runFileName(run.number), run.contents.text});
        index += runFileName(run.number) + ',' + csvCell(run.name) + (run.isShown ? ",yes" : ",no") +
                 (run.isReference ? ",yes," : ",no,") + (run.cor ? formatNumber(*run.cor) : std::string()) +
                 ',' + csvCell(run.version) + '\n';
    }
    files.push_back({indexName, index});
    return files;
}

KeptRuns readRuns(const std::string& folder, const std::string& scenarioPath) {
    if (!isThere(folder)) return {};
    return RunsReader(folder, scenarioPath).read();
}

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
