#include "ui/export/whole_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QSaveFile>

namespace drillwave {

QString replaceFile(const QString& path, const QByteArray& bytes) {
    QSaveFile file(path);
    // Without flush() commit() misses that the last bytes found no room, and puts a short file in place.
    const bool written = file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.flush();
    if (written && file.commit()) return {};
    return file.errorString();
}

QString writeWholeFile(const QString& path, const QByteArray& bytes) {
    const QString reason = replaceFile(path, bytes);
    if (reason.isEmpty()) return {};
    return QCoreApplication::translate("drillwave::WholeFile",
                                       "%1: cannot be written: %2; choose another place or free some space")
        .arg(QDir::toNativeSeparators(path), reason);
}

}  // namespace drillwave
