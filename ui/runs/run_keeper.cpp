// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_keeper.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>

#include "core/file/scenario_reader.h"
#include "core/text/text_input.h"
#include "ui/document/table_name.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

std::string nativePath(const QString& path) {
    return QFile::encodeName(path).toStdString();
}

bool isSame(const std::vector<NamedFile>& a, const std::vector<NamedFile>& b) {
    return std::ranges::equal(a, b, [](const NamedFile& one, const NamedFile& other) {
        return one.name == other.name && one.bytes == other.bytes;
    });
}

/// What is there under the names of these files.
std::vector<NamedFile> filesAsTheyAre(const std::string& folder, const std::vector<NamedFile>& named) {
    std::vector<NamedFile> files;
    for (const NamedFile& file : named) {
        FileBytes found = readFile(folder + "/" + file.name, maximumScenarioBytes);
        if (found.problem.empty()) files.push_back({file.name, std::move(found.bytes)});
    }
    return files;
}

}  // namespace

RunKeeper::RunKeeper(Document& document, Runs& runs, QObject* parent)
    : QObject(parent), m_document(document), m_runs(runs) {
    m_due.setSingleShot(true);
    m_due.setInterval(0);
    connect(&m_due, &QTimer::timeout, this, &RunKeeper::writeNow);
    connect(&document, &Document::saved, this, &RunKeeper::followSaved);
    connect(&document, &Document::replaced, this, [this] {
        leave();
        read();
    });
    connect(&runs, &Runs::changed, this, &RunKeeper::writeSoon);
    connect(&runs, &Runs::differs, this,
            [this](const QString& sentence) { emit failed(tr("A run is not what it was."), sentence); });
}

RunKeeper::~RunKeeper() {
    blockSignals(true);
    if (m_due.isActive()) writeNow();
}

QString RunKeeper::folder() const {
    return m_path.isEmpty() ? QString() : QFile::decodeName(runsFolderOf(nativePath(m_path)).c_str());
}

// What is kept goes with its file.
void RunKeeper::leave() {
    if (m_due.isActive()) writeNow();
    const bool wasKept = m_kept;
    setKept(false);
    m_path = m_document.path();
    m_files.clear();
    m_partial = false;
    m_runs.reserve({});
    if (wasKept) m_runs.clear();
}

void RunKeeper::read() {
    if (m_path.isEmpty()) return;
    const KeptRuns found = readRuns(nativePath(folder()), nativePath(m_path));
    m_runs.reserve(found.foreign);
    m_files = filesAsTheyAre(nativePath(folder()), runFiles(found.runs));
    if (m_files.empty() && found.problems.empty()) return;  // an index without runs is one all the same
    QStringList problems;
    for (const std::string& problem : found.problems) problems << QString::fromStdString(problem);
    for (const QString& title : m_runs.add(found.runs))
        problems
            << tr("%1: there is no room for it among the runs on show; remove some and open the file again")
                   .arg(title);
    for (const int number : found.foreign)
        if (const Run* run = m_runs.find(number))
            problems
                << tr("%1: its file would replace another one in %2; remove the run and open the file again")
                       .arg(run->title(), QDir::toNativeSeparators(folder()));
    // Written without them, the index would lose those that are not on show.
    m_partial = !problems.isEmpty();
    setKept(!m_partial);
    if (!problems.isEmpty())
        emit failed(tr("Not all runs that are kept with this file can be shown."),
                    problems.join(QLatin1Char('\n')));
}

void RunKeeper::followSaved() {
    if (m_document.path() == m_path) return;
    if (m_due.isActive()) writeNow();
    m_path = m_document.path();
    m_files.clear();
    m_partial = false;
    m_runs.reserve({});
    if (!m_kept) return read();
    if (holdsOthers()) {
        setKept(false);
        emit othersFound(folder());
    } else if (const QString problem = keep(); !problem.isEmpty()) {
        setKept(false);
        emit failed(tr("The runs are not kept beside the new file."), problem);
    }
}

bool RunKeeper::holdsOthers() const {
    if (folder().isEmpty()) return false;
    return m_partial || (m_files.empty() && QFileInfo::exists(folder())) || !foreignFile().empty();
}

// A file that is there and not as it was read or written.
bool RunKeeper::isForeign(const std::string& name) const {
    const std::string path = nativePath(folder()) + "/" + name;
    if (!isThere(path)) return false;
    const auto ours = std::ranges::find(m_files, name, &NamedFile::name);
    const FileBytes found = readFile(path, maximumScenarioBytes);
    return ours == m_files.end() || !found.problem.empty() || found.bytes != ours->bytes;
}

// The first one that writing would replace or remove; empty where there is none.
std::string RunKeeper::foreignFile() const {
    std::vector<std::string> names = FolderFiles{runFiles(m_runs.toKeep()), {}}.names();
    for (const NamedFile& file : m_files) names.push_back(file.name);
    const auto found = std::ranges::find_if(names, [this](const auto& name) { return isForeign(name); });
    return found == names.end() ? std::string() : *found;
}

QString RunKeeper::keep(ExistingFiles existing) {
    if (folder().isEmpty())
        return tr("The scenario has no file yet: save it first, the runs are kept beside it.");
    if (const QString problem = write(existing); !problem.isEmpty()) return problem;
    m_runs.reserve(readRuns(nativePath(folder()), nativePath(m_path)).foreign);
    setKept(true);
    return {};
}

void RunKeeper::giveUp() {
    m_due.stop();
    setKept(false);
    for (const NamedFile& file : m_files)
        if (!isForeign(file.name))
            QFile::remove(folder() + QLatin1Char('/') + QString::fromStdString(file.name));
    QFile::remove(folder() + QStringLiteral("/.drillwave.lock"));
    QDir().rmdir(folder());
    m_files.clear();
}

void RunKeeper::setKept(bool kept) {
    if (kept == m_kept) return;
    m_kept = kept;
    emit keptChanged(kept);
}

// Tables that are named relative to another folder are named relative to the scenario's.
std::vector<NamedFile> RunKeeper::files() const {
    std::vector<KeptRun> runs = m_runs.toKeep();
    for (KeptRun& run : runs) {
        std::string& table = run.contents.scenario.pulse.tableFile;
        const std::string seen = tableSeenFrom(m_path, QFile::decodeName(run.contents.source.c_str()), table);
        if (seen == table) continue;
        table = seen;
        run.contents.text = writeScenario(run.contents);
    }
    return runFiles(runs);
}

void RunKeeper::writeSoon() {
    if (m_kept) m_due.start();
}

void RunKeeper::writeNow() {
    m_due.stop();
    if (const QString problem = write(ExistingFiles::kept); !problem.isEmpty()) {
        setKept(false);
        emit failed(tr("The runs are not kept any more."), problem);
    }
}

// The disk is waited for with every file. The index, which is last, tells that the folder is complete.
void RunKeeper::leaveOutWritten(std::vector<NamedFile>& files) const {
    const std::string index = files.back().name;
    std::erase_if(files, [&](const NamedFile& file) {
        const auto ours = std::ranges::find(m_files, file.name, &NamedFile::name);
        const bool isWritten = ours != m_files.end() && ours->bytes == file.bytes;
        return isWritten && file.name != index && isThere(nativePath(folder()) + "/" + file.name);
    });
}

QString RunKeeper::write(ExistingFiles existing) {
    std::vector<NamedFile> wanted;
    try {
        wanted = files();
    } catch (const ScenarioError& error) {
        return QString::fromUtf8(error.what());
    }
    if (m_kept && isSame(m_files, wanted)) return {};
    if (const std::string foreign = foreignFile(); existing == ExistingFiles::kept && !foreign.empty())
        return tr("%1: has been put there or changed by somebody else; move it away, or keep the runs again "
                  "to replace it")
            .arg(QDir::toNativeSeparators(folder() + QLatin1Char('/') + QString::fromStdString(foreign)));
    FolderFiles folderFiles{wanted, {}};
    std::vector<std::string> outdated;
    const std::vector<std::string> names = folderFiles.names();
    for (const NamedFile& file : m_files)
        if (std::ranges::find(names, file.name) == names.end()) outdated.push_back(file.name);
    folderFiles.outdated = [outdated](const std::string&) { return outdated; };
    if (existing == ExistingFiles::kept) leaveOutWritten(folderFiles.files);
    const FolderEnd end = writeWholeFolder(nativePath(folder()), folderFiles, ExistingFiles::replaced);
    if (!end.isWritten()) return translated(end.problem);
    m_files = std::move(wanted);
    m_partial = false;
    return {};
}

}  // namespace drillwave
