// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/whole_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QSaveFile>

namespace drillwave {
namespace {

struct Failure {
    QString reason;  // empty: none
    bool isFull = false;
};

Failure replace(const QString& path, const QByteArray& bytes) {
    QSaveFile file(path);
    const bool written = file.open(QIODevice::WriteOnly | QIODevice::Unbuffered) &&
                         writeAll(file, bytes.constData(), bytes.size());
    if (written && file.commit()) return {};
    return {file.errorString(), isFull(file)};
}

}  // namespace

QString replaceFile(const QString& path, const QByteArray& bytes) {
    return replace(path, bytes).reason;
}

QString writeWholeFile(const QString& path, const QByteArray& bytes, const QString& name) {
    const Failure failure = replace(path, bytes);
    if (failure.reason.isEmpty()) return {};
    const char* text = failure.isFull ? "%1: cannot be written: %2; free some space or choose another place"
                                      : "%1: cannot be written: %2; choose another place";
    return QCoreApplication::translate("drillwave::WholeFile", text)
        .arg(QDir::toNativeSeparators(name.isEmpty() ? path : name), failure.reason);
}

bool writeAll(QFileDevice& file, const char* bytes, qint64 size) {
    while (size > 0) {
        const qint64 written = file.write(bytes, size);
        if (written <= 0) return false;
        bytes += written;
        size -= written;
    }
    return true;
}

bool isFull(const QFileDevice& file) {
    return file.error() == QFileDevice::ResourceError;
}

}  // namespace drillwave
