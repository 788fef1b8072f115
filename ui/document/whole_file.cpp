// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/whole_file.h"

#include <QFile>
#include <string_view>

#include "core/disk/whole_file.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

WriteFailure replace(const QString& path, const QByteArray& bytes) {
    return replaceFile(QFile::encodeName(path).toStdString(),
                       std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
}

}  // namespace

QString replaceFile(const QString& path, const QByteArray& bytes) {
    return QString::fromStdString(replace(path, bytes).reason);
}

QString writeWholeFile(const QString& path, const QByteArray& bytes, const QString& name) {
    const WriteFailure failure = replace(path, bytes);
    return failure ? translated(notWritten((name.isEmpty() ? path : name).toStdString(), failure))
                   : QString();
}

}  // namespace drillwave
