// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/table_name.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

namespace drillwave {

std::string tableSeenFrom(const QString& path, const QString& origin, const std::string& table) {
    const QString name = QFile::decodeName(table.c_str());
    const QDir from = QFileInfo(origin).absoluteDir();
    const QDir to = QFileInfo(path).absoluteDir();
    const bool isElsewhere = !origin.isEmpty() && !path.isEmpty() && from != to;
    if (name.isEmpty() || !isElsewhere || QDir::isAbsolutePath(name)) return table;
    return QFile::encodeName(to.relativeFilePath(from.absoluteFilePath(name))).toStdString();
}

}  // namespace drillwave
