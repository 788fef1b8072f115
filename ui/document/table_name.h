// SPDX-License-Identifier: GPL-3.0-or-later
// How a scenario file names the table of its hammer blow.
#pragma once

#include <QString>
#include <string>

namespace drillwave {

/// The name of a table for the file `path`, when the file `origin` names it `table`: relative names are
/// relative to the folder of the file. The same where one of the files has no name.
std::string tableSeenFrom(const QString& path, const QString& origin, const std::string& table);

}  // namespace drillwave
