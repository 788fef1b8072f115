// SPDX-License-Identifier: GPL-3.0-or-later
// Name of the table of a hammer blow in a scenario file.
#pragma once

#include <QString>
#include <string>

namespace drillwave {

/// Returns the name of a table for the file `path`, when the file `origin` names it `table`: relative names
/// are relative to the folder of the file. Returns `table` if one of the files has no name.
std::string tableSeenFrom(const QString& path, const QString& origin, const std::string& table);

}  // namespace drillwave
