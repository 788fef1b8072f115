// SPDX-License-Identifier: GPL-3.0-or-later
// Files that tests write and read.
#pragma once

#include <QByteArray>
#include <QFile>
#include <QString>

namespace drillwave::test {

/// Returns the bytes of a file; ends the test program if it cannot be read.
inline QByteArray read(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) qFatal("cannot read %s", qPrintable(path));
    return file.readAll();
}

inline void write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("cannot write %s", qPrintable(path));
}

}  // namespace drillwave::test
