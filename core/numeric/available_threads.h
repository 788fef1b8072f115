// SPDX-License-Identifier: GPL-3.0-or-later
// How many threads this process may keep busy.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace drillwave {

/// Returns the processors that the groups of a process may use at most, as 1.5; none without a quota. Reads
/// `cpu.max` (version 2) or `cpu.cfs_quota_us` and `cpu.cfs_period_us` (version 1) of each group and of all
/// groups above it; the smallest quota counts. `groups` is the text of /proc/self/cgroup, `root` the folder
/// where the groups are mounted.
std::optional<double> processorQuota(std::string_view groups, const std::string& root);

/// Returns the number of threads for a number of processors (≥ 1) and a quota: the quota rounded up, at
/// least 1 and at most the processors.
int threadsWithin(int processors, std::optional<double> quota);

/// Returns the threads that this process may keep busy: the processors that it may run on, within the quota
/// of its control groups. The library's count of processors is that of the machine, not that of a job.
int availableThreads();

}  // namespace drillwave
