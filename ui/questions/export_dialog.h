// SPDX-License-Identifier: GPL-3.0-or-later
// Dialogs that ask for a file or a folder to write.
#pragma once

#include <QFileDialog>

namespace drillwave {

/// Dialog that asks for a file in one of several formats. A name without an ending gets that of the chosen
/// filter, such as "pdf" for "PDF (*.pdf)". With a filter of all files it gets the ending of the suggested
/// name.
class ExportDialog : public QFileDialog {
    Q_OBJECT

  public:
    ExportDialog(QWidget* parent, const QString& title, const QString& suggestion, const QString& filter);

  private:
    void follow(const QString& filter);

    QString m_suggested;  // ending of the suggested name
};

// Dialog that asks for a folder to write, which may not exist yet.

/// Dialog that asks for a folder. The user may name a folder that does not exist, and is asked to confirm it.
/// The caller creates it when the files are written.
class FolderDialog : public QFileDialog {
    Q_OBJECT

  public:
    FolderDialog(QWidget* parent, const QString& title, const QString& suggestion);

  public slots:
    void accept() override;
};

}  // namespace drillwave
