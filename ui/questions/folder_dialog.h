// SPDX-License-Identifier: GPL-3.0-or-later
// Asks for a folder to write into, which need not be there yet.
#pragma once

#include <QFileDialog>

namespace drillwave {

/// A name that is new is offered to be made: the folder appears when it is written.
class FolderDialog : public QFileDialog {
    Q_OBJECT

  public:
    FolderDialog(QWidget* parent, const QString& title, const QString& suggestion);

  public slots:
    void accept() override;
};

}  // namespace drillwave
