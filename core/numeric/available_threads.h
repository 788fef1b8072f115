// SPDX-License-Identifier: GPL-3.0-or-later
// Number of threads that this process may keep busy.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace drillwave {

/// Returns the number of processors whose time the Linux control groups (cgroups) of a process allow, such as
/// 1.5; nullopt without a quota. `groups` is the text of /proc/self/cgroup, `root` the folder where the
/// groups are mounted. The smallest quota of all groups and their parents counts. It is read from `cpu.max`
/// (version 2), or from `cpu.cfs_quota_us` and `cpu.cfs_period_us` (version 1).
std::optional<double> processorQuota(std::string_view groups, const std::string& root);

/// Returns the number of threads for this many processors (≥ 1) and this quota, in processors: 2 for a quota
/// of 1.5. It is at least 1 and at most `processors`.
int threadsWithin(int processors, std::optional<double> quota);

/// Returns the number of threads, ≥ 1, that this process may keep busy. It is the number of processors that
/// the process may run on, within its quota of processor time. The function
/// std::thread::hardware_concurrency() gives the processors of the machine instead.
int availableThreads();

}  // namespace drillwave
