// SPDX-License-Identifier: GPL-3.0-or-later
// Version of the program, from the build.
#pragma once

namespace drillwave {

/// "0.2.0" of a release, "0.2.0+203.ga059c129" of a build 203 commits after it.
extern const char* const versionText;

/// Version of names, units and meanings in files and JSON; it rises where one of them changes.
inline constexpr int outputsVersion = 2;

}  // namespace drillwave
