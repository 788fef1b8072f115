// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/questions/export_dialog.h"

#include <QFileInfo>
#include <QRegularExpression>

namespace drillwave {

ExportDialog::ExportDialog(QWidget* parent, const QString& title, const QString& suggestion,
                           const QString& filter)
    : QFileDialog(parent, title, suggestion, filter), m_suggested(QFileInfo(suggestion).suffix()) {
    setAcceptMode(QFileDialog::AcceptSave);
    connect(this, &QFileDialog::filterSelected, this, &ExportDialog::follow);
    follow(selectedNameFilter());
    selectFile(suggestion);
}

void ExportDialog::follow(const QString& filter) {
    static const QRegularExpression firstEnding(QStringLiteral("\\*\\.(\\w+)"));
    const QRegularExpressionMatch ending = firstEnding.match(filter);
    setDefaultSuffix(ending.hasMatch() ? ending.captured(1) : m_suggested);
}

}  // namespace drillwave
