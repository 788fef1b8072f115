// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file/hidden_folder.h"

#include <stdlib.h>  // mkdtemp() is POSIX
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "core/file/whole_folder.h"
#include "core/text/text_input.h"

namespace drillwave {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view namesBegin = ".drillwave-";

std::string listIn(const std::string& hidden) {
    return hidden + "/exchange";
}

/// Names end with NUL, the only byte that they cannot hold.
std::vector<std::string> namesIn(const std::string& hidden) {
    constexpr std::size_t mostBytes = std::size_t{1} << 20;
    std::vector<std::string> names;
    const FileBytes list = readFile(listIn(hidden), mostBytes);
    std::string_view rest = list.bytes;
    for (std::size_t end = rest.find('\0'); end != std::string_view::npos; end = rest.find('\0')) {
        names.emplace_back(rest.substr(0, end));
        rest.remove_prefix(end + 1);
    }
    return names;
}

std::vector<std::string> filesIn(const std::string& folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        names.push_back(entry->path().filename());
    return names;
}

/// What other runs have hidden there, dead or alive.
std::vector<std::string> hiddenIn(const std::string& folder) {
    std::vector<std::string> paths;
    std::error_code ignored;
    for (const std::string& name : filesIn(folder))
        if (name.starts_with(namesBegin) && fs::is_directory(pathInside(folder, name), ignored))
            paths.push_back(pathInside(folder, name));
    return paths;
}

/// As it was before the exchange. Can be interrupted and done again.
void takeBack(const std::string& folder, const std::string& hidden) {
    const std::string come = hidden + "/new", gone = hidden + "/old";
    for (const std::string& name : namesIn(hidden))
        if (!isThere(pathInside(come, name)))
            std::rename(pathInside(folder, name).c_str(), pathInside(come, name).c_str());
    // Whoever has put a file of that name there meanwhile knows better.
    for (const std::string& name : filesIn(gone))
        if (!isThere(pathInside(folder, name)))
            std::rename(pathInside(gone, name).c_str(), pathInside(folder, name).c_str());
}

void mend(const std::string& folder, const std::string& hidden) {
    FolderLock lock(hidden);
    if (lock.tryLock() != 0) return;
    if (!filesIn(hidden + "/new").empty()) takeBack(folder, hidden);
    std::error_code ignored;
    fs::remove(listIn(hidden), ignored);
    fs::remove_all(hidden, ignored);
}

}  // namespace

HiddenFolder::~HiddenFolder() {
    std::error_code ignored;
    if (m_path.empty()) return;
    fs::remove_all(m_path, ignored);
    // Once more with the open file of the lock to spare: it may be the last one permitted.
    m_lock.reset();
    fs::remove_all(m_path, ignored);
}

int HiddenFolder::make(const std::string& parent) {
    assert(!isMade());
    // Under a name that no mending run looks for until it is locked: else one takes it for that of a dead
    // run.
    constexpr std::string_view unlockedBegin = ".drillwave_";
    std::string path = pathInside(parent, std::string(unlockedBegin) + "XXXXXX");
    if (!::mkdtemp(path.data())) return errno;
    auto lock = std::make_unique<FolderLock>(path);
    int error = lock->tryLock();
    // On a disk without locks it works as well, but for being mended.
    if (areLocksUnknown(error)) error = 0;
    for (const char* part : {"/new", "/old"}) {
        std::error_code problem;
        if (error == 0 && !fs::create_directory(path + part, problem)) error = problem.value();
    }
    std::string found = path;
    found.replace(found.size() - unlockedBegin.size() - 6, namesBegin.size(), namesBegin);
    if (error == 0 && std::rename(path.c_str(), found.c_str()) != 0) error = errno;
    if (error != 0) {
        std::error_code ignored;
        fs::remove_all(path, ignored);
        ::rmdir(path.c_str());  // needs no open file, of which there may be none left
        return error;
    }
    m_path = std::move(found);
    m_lock = std::move(lock);
    return 0;
}

WriteFailure HiddenFolder::beginExchange(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += name + '\0';
    return replaceFile(listIn(m_path), list);
}

void HiddenFolder::endExchange() {
    ::unlink(listIn(m_path).c_str());
}

void mendLockedFolder(const std::string& folder) {
    for (const std::string& hidden : hiddenIn(folder)) mend(folder, hidden);
}

void mendFolder(const std::string& folder) {
    if (hiddenIn(folder).empty()) return;
    FolderLock lock(folder);
    if (lock.tryLock() == 0) mendLockedFolder(folder);
}

}  // namespace drillwave
