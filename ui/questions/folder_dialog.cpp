// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/questions/folder_dialog.h"

#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

namespace drillwave {

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
    QMessageBox box(QMessageBox::Question, windowTitle(), tr("There is no such folder yet. Make it?"),
                    QMessageBox::Cancel, this);
    box.setInformativeText(QDir::toNativeSeparators(chosen));
    QPushButton* make = box.addButton(tr("Make it"), QMessageBox::AcceptRole);
    box.setDefaultButton(make);
    box.exec();
    if (box.clickedButton() == make) done(QDialog::Accepted);
}

}  // namespace drillwave
