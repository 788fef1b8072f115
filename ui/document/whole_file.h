// SPDX-License-Identifier: GPL-3.0-or-later
// A file written whole or not at all.
#pragma once

#include <QByteArray>
#include <QString>

class QFileDevice;

namespace drillwave {

/// Writes beside the file and puts that in its place when all of it is on the disk; a link stays a link to
/// the file, permissions stay. Returns why not, in one line that begins with the path, or with `name` where
/// the path says nothing to people; then the file is as it was.
QString writeWholeFile(const QString& path, const QByteArray& bytes, const QString& name = {});

/// The same; returns the mere reason.
QString replaceFile(const QString& path, const QByteArray& bytes);

/// Writes all bytes to a file opened with QIODevice::Unbuffered, or false. Where only a part finds room, Qt
/// forgets why: the rest is tried again for the reason, which errorString() then tells.
bool writeAll(QFileDevice& file, const char* bytes, qint64 size);

/// Whether writing failed because the disk is full, so that it helps to free some space.
bool isFull(const QFileDevice& file);

}  // namespace drillwave
