// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/disk/whole_folder.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <thread>
#include <utility>

#include "core/disk/hidden_folder.h"
#include "core/disk/whole_file.h"

namespace drillwave {
namespace {

namespace fs = std::filesystem;

/// Others hold the lock for the milliseconds of some renames; longer than this, one of them hangs.
constexpr std::chrono::seconds longestWait{20};
constexpr std::chrono::seconds silentWait{2};          // after which the caller is notified
constexpr std::chrono::milliseconds lockPatience{10};  // between looks at the lock and at the stop token

/// Parents that vanish between being made and being used: another run that failed took its own away.
constexpr int mostAttempts = 5;

FolderEnd failed(Message problem) {
    return {FolderEnd::Kind::failed, std::move(problem)};
}

std::string reasonOf(int error) {
    return std::generic_category().message(error);
}

Message notMade(const std::string& folder, const std::string& reason) {
    return {translatable("%1: the folder cannot be made: %2; choose another one"), {folder, reason}};
}

Message notLocked(const std::string& lockPath, int error) {
    std::error_code ignored;
    const Message reason =
        fs::is_symlink(lockPath, ignored) ? Message(translatable("it is a link")) : Message(reasonOf(error));
    return {translatable("%1: this lock of the folder cannot be opened: %2; remove it or choose another "
                         "folder"),
            {lockPath, reason}};
}

/// 0, or the errno.
int renameEntry(const std::string& from, const std::string& to) {
    return std::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

bool isFolder(const std::string& path) {
    std::error_code ignored;
    return fs::is_directory(path, ignored);
}

/// Why a file of that name may not be put there.
Message nameProblem(const std::string& path, ExistingFiles existing) {
    if (!isThere(path)) return {};
    std::error_code ignored;
    if (!fs::is_symlink(path, ignored) && !fs::is_regular_file(path, ignored))
        return {translatable("%1: is there and no file; choose another folder"), {path}};
    if (existing == ExistingFiles::kept)
        return {translatable("%1: exists already; choose another folder or ask for it to be overwritten"),
                {path}};
    return {};
}

Message namesProblem(const std::string& folder, const std::vector<std::string>& names,
                     ExistingFiles existing) {
    for (const std::string& name : names)
        if (Message problem = nameProblem(pathInside(folder, name), existing); !problem.isEmpty())
            return problem;
    return {};
}

std::string withoutTrailingSlashes(std::string path) {
    while (path.size() > 1 && path.ends_with('/')) path.pop_back();
    return path;
}

/// Returns the name of the file without its folder.
std::string nameOf(const WholeFile& file) {
    return fs::path(file.path()).filename();
}

/// The folder that holds an entry: "." for a bare name.
std::string parentOf(const std::string& path) {
    const std::string parent = fs::path(path).parent_path();
    return parent.empty() ? "." : parent;
}

/// The folders above one that is to be; those made here go again, unless something has come into them.
class Parents {
  public:
    Parents() = default;
    ~Parents() {
        std::error_code ignored;
        if (!m_kept)
            for (const auto& folder : m_made) fs::remove(folder, ignored);
    }
    Parents(const Parents&) = delete;
    Parents& operator=(const Parents&) = delete;

    void keep() { m_kept = true; }

    /// The reason why not.
    std::string make(const fs::path& folder) {
        std::vector<fs::path> missing;  // the deepest first
        std::error_code error;
        for (fs::path path = folder; !path.empty() && !fs::exists(path, error); path = path.parent_path())
            missing.push_back(path);
        for (auto path = missing.rbegin(); path != missing.rend(); ++path) {
            error.clear();
            if (fs::create_directory(*path, error)) m_made.insert(m_made.begin(), *path);
            if (error) return error.message();
        }
        return isFolder(folder) ? std::string() : reasonOf(ENOTDIR);
    }

  private:
    std::vector<fs::path> m_made;
    bool m_kept = false;
};

/// Renames that can be taken back.
class Moves {
  public:
    /// 0, or the errno.
    int move(const std::string& from, const std::string& to) {
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
    std::vector<std::pair<std::string, std::string>> m_done;
};

/// One folder on its way.
class Delivery {
  public:
    Delivery(const std::string& folder, const FolderFiles& files, ExistingFiles existing,
             const std::stop_token& stop, const OnLongWait& onLongWait)
        : m_folder(withoutTrailingSlashes(folder)),
          m_files(files),
          m_existing(existing),
          m_stop(stop),
          m_onLongWait(onLongWait) {}

    FolderEnd run() {
        if (isThere(m_folder) && !isFolder(m_folder)) return failed(notMade(m_folder, reasonOf(ENOTDIR)));
        const std::string around = isFolder(m_folder) ? m_folder : parentOf(m_folder);
        mendFolder(around);
        // Where a run died that had just made the folder, and had not cleaned up around it.
        if (around == m_folder) mendFolder(parentOf(m_folder));
        FolderEnd end = prepare(around);
        if (end.isWritten()) end = place();
        if (end.isWritten()) m_parents.keep();
        return end;
    }

  private:
    FolderEnd notWrittenHere(const std::string& name, const WriteFailure& failure) const {
        // Named as what it is to become: nobody knows of the hidden one.
        return failed(notWritten(pathInside(m_folder, name), failure));
    }

    /// Writes all files where nobody sees them.
    FolderEnd prepare(const std::string& parent) {
        std::string reason;
        for (int attempt = 0; attempt < mostAttempts && !m_hidden.isMade(); ++attempt) {
            reason = m_parents.make(parent);
            if (!reason.empty()) continue;
            if (const int error = m_hidden.make(parent); error != 0) reason = reasonOf(error);
        }
        if (!m_hidden.isMade()) return failed(notMade(m_folder, reason));
        for (const NamedFile& file : m_files.files) {
            if (m_stop.stop_requested()) return {FolderEnd::Kind::stopped, {}};
            if (const WriteFailure failure = replaceFile(m_hidden.newFile(file.name), file.bytes))
                return notWrittenHere(file.name, failure);
        }
        if (m_stop.stop_requested()) return {FolderEnd::Kind::stopped, {}};
        if (!m_files.last) return {};
        const std::string name = nameOf(*m_files.last);
        const WriteFailure failure = m_files.last->commitAs(m_hidden.newFile(name));
        return failure ? notWrittenHere(name, failure) : FolderEnd{};
    }

    /// Puts them in place: at once where the folder is not there yet.
    FolderEnd place() {
        if (m_stop.stop_requested()) return {FolderEnd::Kind::stopped, {}};
        if (!isFolder(m_folder)) {
            // Takes the place of nothing, or of a folder made meanwhile if it is empty.
            const int error = renameEntry(m_hidden.newFolder(), m_folder);
            if (error == 0) return {};
            if (!isFolder(m_folder)) return failed(notMade(m_folder, reasonOf(error)));
        }
        return exchangeLocked();
    }

    FolderEnd exchangeLocked() {
        FolderLock lock(m_folder);
        const auto begin = std::chrono::steady_clock::now();
        bool isNotified = !m_onLongWait;
        while (const int error = lock.tryLock()) {
            if (m_stop.stop_requested()) return {FolderEnd::Kind::stopped, {}};
            if (isLockingUnsupported(error)) break;
            if (error != EWOULDBLOCK)
                return failed(isThere(lock.path()) ? notLocked(lock.path(), error)
                                                   : notWritten(m_folder, {reasonOf(error), false}));
            const auto waited = std::chrono::steady_clock::now() - begin;
            if (waited > silentWait && !std::exchange(isNotified, true)) m_onLongWait(lock.path());
            if (waited > longestWait)
                return failed(
                    {translatable("%1: another run has been writing there for %2 seconds; wait for it or "
                                  "choose another folder"),
                     {m_folder, std::to_string(longestWait.count())}});
            std::this_thread::sleep_for(lockPatience);
        }
        if (m_stop.stop_requested()) return {FolderEnd::Kind::stopped, {}};
        mendLockedFolder(m_folder);
        return exchange();
    }

    /// Returns the names of files to be replaced or removed, the last first.
    std::vector<std::string> leavingNames() const {
        std::vector<std::string> leaving = m_files.names();
        std::ranges::reverse(leaving);
        if (!m_files.outdated) return leaving;
        for (const std::string& name : m_files.outdated(m_folder))
            if (std::ranges::find(leaving, name) == leaving.end()) leaving.push_back(name);
        return leaving;
    }

    /// Requires the lock.
    FolderEnd exchange() {
        const std::vector<std::string> names = m_files.names();
        const std::vector<std::string> leaving = leavingNames();
        if (Message problem = namesProblem(m_folder, leaving, m_existing); !problem.isEmpty())
            return failed(std::move(problem));
        if (const WriteFailure failure = m_hidden.beginExchange(names))
            return failed(notWritten(m_folder, failure));
        Moves moves;
        FolderEnd end = moveAll(moves, leaving, names);
        if (!end.isWritten()) moves.takeBack();
        m_hidden.endExchange();
        return end;
    }

    /// Moves replaced files aside first, so that a failure can restore them.
    FolderEnd moveAll(Moves& moves, const std::vector<std::string>& leaving,
                      const std::vector<std::string>& names) const {
        for (const std::string& name : leaving) {
            const std::string path = pathInside(m_folder, name);
            if (!isThere(path)) continue;
            if (const int error = moves.move(path, m_hidden.oldFile(name)); error != 0)
                return notWrittenHere(name, {reasonOf(error), false});
        }
        for (const std::string& name : names)
            if (const int error = moves.move(m_hidden.newFile(name), pathInside(m_folder, name)); error != 0)
                return notWrittenHere(name, {reasonOf(error), false});
        return {};
    }

    std::string m_folder;
    const FolderFiles& m_files;
    ExistingFiles m_existing;
    std::stop_token m_stop;
    const OnLongWait& m_onLongWait;
    Parents m_parents;  // outlives what is in them
    HiddenFolder m_hidden;
};

/// The folder itself, or the nearest one above it that exists.
std::string nearestExisting(const std::string& folder) {
    std::string path = withoutTrailingSlashes(folder);
    while (!isThere(path) && parentOf(path) != path) path = parentOf(path);
    return path;
}

}  // namespace

bool isThere(const std::string& path) {
    std::error_code error;
    const fs::file_status status = fs::symlink_status(path, error);
    return status.type() != fs::file_type::none && status.type() != fs::file_type::not_found;
}

std::string pathInside(const std::string& folder, const std::string& name) {
    if (folder == ".") return name;
    return folder.ends_with('/') ? folder + name : folder + "/" + name;
}

std::vector<std::string> FolderFiles::names() const {
    std::vector<std::string> names;
    for (const NamedFile& file : files) names.push_back(file.name);
    if (last) names.push_back(nameOf(*last));
    return names;
}

FolderEnd writeWholeFolder(const std::string& folder, const FolderFiles& files, ExistingFiles existing,
                           const std::stop_token& stop, const OnLongWait& onLongWait) {
    return Delivery(folder, files, existing, stop, onLongWait).run();
}

Message lockProblem(const std::string& folder) {
    FolderLock lock(folder);
    if (!isThere(lock.path())) return {};
    const int error = lock.tryLock();
    return error == 0 || error == EWOULDBLOCK || isLockingUnsupported(error) ? Message()
                                                                             : notLocked(lock.path(), error);
}

Message folderProblem(const std::string& folder, const std::vector<std::string>& names,
                      ExistingFiles existing) {
    const std::string nearest = nearestExisting(folder);
    std::error_code ignored;
    if (!isFolder(nearest))
        return notMade(folder, reasonOf(fs::is_symlink(nearest, ignored) ? ENOENT : ENOTDIR));
    if (::access(nearest.c_str(), W_OK) != 0) return notMade(folder, reasonOf(errno));
    if (Message problem = lockProblem(folder); !problem.isEmpty()) return problem;
    return namesProblem(folder, names, existing);
}

}  // namespace drillwave
