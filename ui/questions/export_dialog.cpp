// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/questions/export_dialog.h"

#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
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

FolderDialog::FolderDialog(QWidget* parent, const QString& title, const QString& suggestion)
    : QFileDialog(parent, title, suggestion) {
    // The dialogs of desktops take only folders that are there.
    setOption(QFileDialog::DontUseNativeDialog);
    setOption(QFileDialog::ShowDirsOnly);
    setFileMode(QFileDialog::Directory);
    setLabelText(QFileDialog::Accept, tr("Export"));
}

void FolderDialog::accept() {
    const QString chosen = selectedFiles().value(0);
    if (chosen.isEmpty() || QFileInfo::exists(chosen)) return QFileDialog::accept();
    QMessageBox box(QMessageBox::Question, windowTitle(), tr("This folder does not exist yet. Create it?"),
                    QMessageBox::Cancel, this);
    box.setInformativeText(QDir::toNativeSeparators(chosen));
    QPushButton* make = box.addButton(tr("Create"), QMessageBox::AcceptRole);
    box.setDefaultButton(make);
    box.exec();
    if (box.clickedButton() == make) done(QDialog::Accepted);
}

}  // namespace drillwave
