// SPDX-License-Identifier: GPL-3.0-or-later
// Name of the CSV table with the hammer force, as written in a scenario file.
#pragma once

#include <QString>
#include <string>

namespace drillwave {

/// Returns the name of a table file (CSV of the hammer force) as written in the scenario file `path`. `table`
/// is its name in the scenario file `origin`. Relative names are relative to the folder of the file that
/// contains them. Returns `table` unchanged if either path is empty.
std::string tableSeenFrom(const QString& path, const QString& origin, const std::string& table);

}  // namespace drillwave
