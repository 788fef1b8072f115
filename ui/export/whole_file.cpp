#include "ui/export/whole_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QSaveFile>

namespace drillwave {

QString writeWholeFile(const QString& path, const QByteArray& bytes) {
    QSaveFile file(path);
    if (file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.commit()) return {};
    return QCoreApplication::translate("drillwave::WholeFile",
                                       "%1: cannot be written: %2; choose another place or free some space")
        .arg(QDir::toNativeSeparators(path), file.errorString());
}

}  // namespace drillwave
