// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/available_threads.h"

#include <sched.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

namespace drillwave {

namespace {

namespace fs = std::filesystem;

std::optional<double> quotaOf(double quota, double period) {
    return quota > 0 && period > 0 ? std::optional(quota / period) : std::nullopt;
}

/// Returns the quota of one group: "150000 100000" in version 2, where no quota is "max".
std::optional<double> quotaOfGroup(const fs::path& group) {
    double quota = 0;
    double period = 0;
    if (std::ifstream file(group / "cpu.max"); file >> quota >> period) return quotaOf(quota, period);
    std::ifstream quotaFile(group / "cpu.cfs_quota_us");
    std::ifstream periodFile(group / "cpu.cfs_period_us");
    return quotaFile >> quota && periodFile >> period ? quotaOf(quota, period) : std::nullopt;
}

/// Takes the smallest quota of the group `path` below `mount` and of all groups above it.
void takeQuotas(const fs::path& mount, fs::path path, std::optional<double>& smallest) {
    for (;; path = path.parent_path()) {
        const std::optional<double> quota = quotaOfGroup(mount / path.relative_path());
        if (quota && (!smallest || *quota < *smallest)) smallest = quota;
        if (!path.has_relative_path()) return;
    }
}

bool namesProcessors(std::string_view controllers) {
    return ("," + std::string(controllers) + ",").find(",cpu,") != std::string::npos;
}

/// Returns the processors that the calling thread may run on; 0 where the system does not say.
int permittedProcessors() {
    int count = 0;
#ifdef __linux__
    // The set must be as large as that of the kernel, which is known by trying only.
    constexpr int mostProcessors = 1 << 20;
    for (int size = CPU_SETSIZE; count == 0 && size <= mostProcessors; size *= 2) {
        cpu_set_t* set = CPU_ALLOC(static_cast<std::size_t>(size));
        if (!set) break;
        const std::size_t bytes = CPU_ALLOC_SIZE(static_cast<std::size_t>(size));
        if (::sched_getaffinity(0, bytes, set) == 0) count = CPU_COUNT_S(bytes, set);
        CPU_FREE(set);
    }
#endif
    return count;
}

}  // namespace

std::optional<double> processorQuota(std::string_view groups, const std::string& root) {
    std::optional<double> smallest;
    while (!groups.empty()) {
        const std::string_view line = groups.substr(0, groups.find('\n'));
        groups.remove_prefix(std::min(groups.size(), line.size() + 1));
        // NUMBER:CONTROLLERS:PATH, in version 2 without controllers.
        const std::size_t first = line.find(':');
        const std::size_t second = line.find(':', first + 1);
        if (second == std::string_view::npos) continue;
        const std::string_view controllers = line.substr(first + 1, second - first - 1);
        const fs::path path(line.substr(second + 1));
        if (controllers.empty())
            takeQuotas(root, path, smallest);
        else if (namesProcessors(controllers))
            takeQuotas(fs::path(root) / controllers, path, smallest);
    }
    return smallest;
}

int threadsWithin(int processors, std::optional<double> quota) {
    const double threads = quota ? std::min<double>(processors, std::ceil(*quota)) : processors;
    return std::max(1, static_cast<int>(threads));
}

int availableThreads() {
    int processors = permittedProcessors();
    if (processors == 0) processors = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    std::ifstream file("/proc/self/cgroup");
    const std::string groups{std::istreambuf_iterator<char>(file), {}};
    return threadsWithin(processors, processorQuota(groups, "/sys/fs/cgroup"));
}

}  // namespace drillwave
