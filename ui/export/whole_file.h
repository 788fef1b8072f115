// A file written whole or not at all.
#pragma once

#include <QByteArray>
#include <QString>

namespace drillwave {

/// Writes beside the file and puts that in its place when all of it is on the disk; a link stays a link to
/// the file, permissions stay. Returns why not, in one line that begins with the path; then the file is as it
/// was.
QString writeWholeFile(const QString& path, const QByteArray& bytes);

/// The same; returns the mere reason.
QString replaceFile(const QString& path, const QByteArray& bytes);

}  // namespace drillwave
