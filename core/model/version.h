// SPDX-License-Identifier: GPL-3.0-or-later
// Version of the program, from the build.
#pragma once

namespace drillwave {

/// Version of the program: "0.2.0" for a release, "0.2.0+203.ga059c129" for a build 203 commits after it.
extern const char* const versionText;

/// Number of the version of the output formats: of names, units and meanings in files and JSON. It increases
/// when any of them changes.
inline constexpr int outputsVersion = 2;

}  // namespace drillwave
