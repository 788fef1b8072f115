// SPDX-License-Identifier: GPL-3.0-or-later
// Asks for a file to write, of one of several formats.
#pragma once

#include <QFileDialog>

namespace drillwave {

/// A name without an ending gets that of the chosen filter, "PDF (*.pdf)"; of one that takes all files, that
/// of the suggestion.
class ExportDialog : public QFileDialog {
    Q_OBJECT

  public:
    ExportDialog(QWidget* parent, const QString& title, const QString& suggestion, const QString& filter);

  private:
    void follow(const QString& filter);

    QString m_suggested;  // ending
};

// Asks for a folder to write into, which need not be there yet.

/// A name that is new is offered to be made: the folder appears when it is written.
class FolderDialog : public QFileDialog {
    Q_OBJECT

  public:
    FolderDialog(QWidget* parent, const QString& title, const QString& suggestion);

  public slots:
    void accept() override;
};

}  // namespace drillwave
