// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/whole_folder.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QLockFile>
#include <QTemporaryDir>
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include "ui/document/whole_file.h"

namespace drillwave {
namespace {

using Kind = FolderEnd::Kind;

const QString lockName = QStringLiteral(".drillwave.lock");
const QString hiddenName = QStringLiteral(".drillwave-XXXXXX");

/// Others hold the lock for the milliseconds of some renames; longer than this, one of them hangs.
constexpr std::chrono::seconds longestWait{20};
constexpr int lockPatience = 10;  // ms between looks at the lock and at the stop token

/// Parents that vanish between being made and being used: another run that failed took its own away.
constexpr int mostAttempts = 5;

QString tr(const char* text) {
    return QCoreApplication::translate("drillwave::WholeFolder", text);
}

QString shown(const QString& path) {
    return QDir::toNativeSeparators(path);
}

FolderEnd failed(const QString& problem) {
    return {Kind::failed, problem};
}

QString notMade(const QString& folder, const QString& reason) {
    return tr("%1: the folder cannot be made: %2; choose another one").arg(shown(folder), reason);
}

QString notWritten(const QString& path, const QString& reason) {
    return tr("%1: cannot be written: %2; choose another place").arg(shown(path), reason);
}

QString reasonOf(int error) {
    return QString::fromStdString(std::generic_category().message(error));
}

std::filesystem::path native(const QString& path) {
    return QFile::encodeName(path).toStdString();
}

/// 0, or the errno.
int renameEntry(const QString& from, const QString& to) {
    return std::rename(QFile::encodeName(from).constData(), QFile::encodeName(to).constData()) == 0 ? 0
                                                                                                    : errno;
}

bool isThere(const QFileInfo& info) {
    // A dangling link exists too.
    return info.exists() || info.isSymLink();
}

/// Why a file of that name may not be put there.
QString nameProblem(const QString& path, ExistingFiles existing) {
    const QFileInfo info(path);
    if (!isThere(info)) return {};
    if (!info.isSymLink() && !info.isFile())
        return tr("%1: is there and no file; choose another folder").arg(shown(path));
    if (existing == ExistingFiles::kept)
        return tr("%1: exists already; choose another folder or ask for it to be overwritten")
            .arg(shown(path));
    return {};
}

QString namesProblem(const QDir& folder, const QStringList& names, ExistingFiles existing) {
    for (const QString& name : names)
        if (const QString problem = nameProblem(folder.filePath(name), existing); !problem.isEmpty())
            return problem;
    return {};
}

QString withoutTrailingSlashes(QString path) {
    while (path.size() > 1 && path.endsWith(QLatin1Char('/'))) path.chop(1);
    return path;
}

/// The folders above one that is to be; those made here go again, unless something has come into them.
class Parents {
  public:
    Parents() = default;
    ~Parents() {
        std::error_code ignored;
        if (!m_kept)
            for (const auto& folder : m_made) std::filesystem::remove(folder, ignored);
    }
    Parents(const Parents&) = delete;
    Parents& operator=(const Parents&) = delete;

    void keep() { m_kept = true; }

    /// The reason why not.
    QString make(const QString& folder) {
        std::vector<std::filesystem::path> missing;  // the deepest first
        std::error_code error;
        for (auto path = native(folder); !path.empty() && !std::filesystem::exists(path, error);
             path = path.parent_path())
            missing.push_back(path);
        for (auto path = missing.rbegin(); path != missing.rend(); ++path) {
            error.clear();
            if (std::filesystem::create_directory(*path, error)) m_made.insert(m_made.begin(), *path);
            if (error) return QString::fromStdString(error.message());
        }
        return std::filesystem::is_directory(native(folder), error) ? QString() : reasonOf(ENOTDIR);
    }

  private:
    std::vector<std::filesystem::path> m_made;
    bool m_kept = false;
};

/// Renames that can be taken back.
class Moves {
  public:
    /// 0, or the errno.
    int move(const QString& from, const QString& to) {
        const int error = renameEntry(from, to);
        if (error == 0) m_done.emplace_back(from, to);
        return error;
    }
    void takeBack() {
        for (auto move = m_done.rbegin(); move != m_done.rend(); ++move)
            renameEntry(move->second, move->first);
        m_done.clear();
    }

  private:
    std::vector<std::pair<QString, QString>> m_done;
};

/// One folder on its way: a hidden folder with `new`, complete, and `old`, what had to give way.
class Delivery {
  public:
    Delivery(const QString& folder, const FolderFiles& files, ExistingFiles existing,
             const std::stop_token& stop)
        : m_folder(withoutTrailingSlashes(folder)), m_files(files), m_existing(existing), m_stop(stop) {}

    FolderEnd run() {
        const QFileInfo target(m_folder);
        if (isThere(target) && !target.isDir()) return failed(notMade(m_folder, reasonOf(ENOTDIR)));
        FolderEnd end = target.isDir() ? prepare(m_folder) : prepare(target.path());
        if (end.isWritten()) end = place();
        if (end.isWritten()) m_parents.keep();
        m_hidden.reset();
        return end;
    }

  private:
    QString hidden(const char* part) const { return m_hidden->filePath(QLatin1String(part)); }
    QString newFile(const QString& name) const { return hidden("new") + QLatin1Char('/') + name; }

    /// Writes all files where nobody sees them.
    FolderEnd prepare(const QString& parent) {
        QString reason;
        for (int attempt = 0; attempt < mostAttempts && !(m_hidden && m_hidden->isValid()); ++attempt) {
            reason = m_parents.make(parent);
            if (!reason.isEmpty()) continue;
            m_hidden = std::make_unique<QTemporaryDir>(QDir(parent).filePath(hiddenName));
            reason = m_hidden->errorString();
        }
        if (!m_hidden || !m_hidden->isValid()) return failed(notMade(m_folder, reason));
        for (const char* part : {"new", "old"})
            if (!QDir().mkdir(hidden(part))) return failed(notMade(m_folder, reasonOf(errno)));
        for (const NamedFile& file : m_files.files) {
            if (m_stop.stop_requested()) return {Kind::stopped, {}};
            // Named as what it is to become: nobody knows of the hidden one.
            const QString problem =
                writeWholeFile(newFile(file.name), file.bytes, QDir(m_folder).filePath(file.name));
            if (!problem.isEmpty()) return failed(problem);
        }
        return {};
    }

    /// Puts them in place: at once where the folder is not there yet.
    FolderEnd place() {
        if (m_stop.stop_requested()) return {Kind::stopped, {}};
        if (!QFileInfo(m_folder).isDir()) {
            // Takes the place of nothing, or of a folder made meanwhile if it is empty.
            const int error = renameEntry(hidden("new"), m_folder);
            if (error == 0) return {};
            if (!QFileInfo(m_folder).isDir()) return failed(notMade(m_folder, reasonOf(error)));
        }
        return exchangeLocked();
    }

    FolderEnd exchangeLocked() {
        QLockFile lock(QDir(m_folder).filePath(lockName));
        const auto end = std::chrono::steady_clock::now() + longestWait;
        while (!lock.tryLock(lockPatience)) {
            if (m_stop.stop_requested()) return {Kind::stopped, {}};
            if (lock.error() != QLockFile::LockFailedError)
                return failed(notWritten(m_folder, reasonOf(EACCES)));
            if (std::chrono::steady_clock::now() > end)
                return failed(tr("%1: another run has been writing there for %2 seconds; wait for it or "
                                 "choose another folder")
                                  .arg(shown(m_folder))
                                  .arg(longestWait.count()));
        }
        if (m_stop.stop_requested()) return {Kind::stopped, {}};
        return exchange();
    }

    /// Under the lock. What is replaced is put aside first, so that a failure can bring it back.
    FolderEnd exchange() {
        const QDir folder(m_folder);
        const QStringList names = m_files.names();
        if (const QString problem = namesProblem(folder, names, m_existing); !problem.isEmpty())
            return failed(problem);
        QStringList leaving = names;
        std::reverse(leaving.begin(), leaving.end());
        if (m_files.outdated) leaving += m_files.outdated(folder);
        leaving.removeDuplicates();
        if (const QString problem = namesProblem(folder, leaving, ExistingFiles::replaced);
            !problem.isEmpty())
            return failed(problem);
        Moves moves;
        const auto move = [&](const QString& from, const QString& to, const QString& name) {
            const int error = moves.move(from, to);
            if (error == 0) return FolderEnd{};
            moves.takeBack();
            return failed(notWritten(folder.filePath(name), reasonOf(error)));
        };
        for (const QString& name : leaving) {
            const QString path = folder.filePath(name);
            if (!isThere(QFileInfo(path))) continue;
            const FolderEnd end = move(path, hidden("old") + QLatin1Char('/') + name, name);
            if (!end.isWritten()) return end;
        }
        for (const QString& name : names) {
            const FolderEnd end = move(newFile(name), folder.filePath(name), name);
            if (!end.isWritten()) return end;
        }
        return {};
    }

    QString m_folder;
    const FolderFiles& m_files;
    ExistingFiles m_existing;
    std::stop_token m_stop;
    Parents m_parents;                        // outlives what is in them
    std::unique_ptr<QTemporaryDir> m_hidden;  // goes with all that is still in it
};

/// The folder itself, or the nearest one above it that exists.
QFileInfo nearestExisting(const QString& folder) {
    QFileInfo info(withoutTrailingSlashes(folder));
    while (!isThere(info) && info.path() != info.filePath()) info = QFileInfo(info.path());
    return info;
}

}  // namespace

QStringList FolderFiles::names() const {
    QStringList names;
    for (const NamedFile& file : files) names.append(file.name);
    return names;
}

FolderEnd writeWholeFolder(const QString& folder, const FolderFiles& files, ExistingFiles existing,
                           const std::stop_token& stop) {
    return Delivery(folder, files, existing, stop).run();
}

QString folderProblem(const QString& folder, const QStringList& names, ExistingFiles existing) {
    const QFileInfo nearest = nearestExisting(folder);
    if (!nearest.isDir()) return notMade(folder, reasonOf(nearest.isSymLink() ? ENOENT : ENOTDIR));
    if (!nearest.isWritable()) return notMade(folder, reasonOf(EACCES));
    return namesProblem(QDir(folder), names, existing);
}

}  // namespace drillwave
