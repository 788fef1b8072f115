// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_place.h"

#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>

#include "ui/text/settings.h"

namespace drillwave {
namespace {

const QString folderKey = QStringLiteral("export/folder");

}  // namespace

QString exportSuggestion(const Document& document, const QString& ending) {
    const QFileInfo scenario(document.suggestedPath());
    const QString folder = Settings().value(folderKey, scenario.absolutePath()).toString();
    return QDir(folder).filePath(scenario.completeBaseName() + ending);
}

void rememberExportFolder(const QString& path) {
    const QFileInfo info(path);
    Settings().setValue(folderKey, info.isDir() ? info.absoluteFilePath() : info.absolutePath());
}

WaitCursor::WaitCursor() {
    QGuiApplication::setOverrideCursor(Qt::WaitCursor);
}

WaitCursor::~WaitCursor() {
    QGuiApplication::restoreOverrideCursor();
}

}  // namespace drillwave
