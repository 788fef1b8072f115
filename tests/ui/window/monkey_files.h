// SPDX-License-Identifier: GPL-3.0-or-later
// Files for a monkey to open, drop, save over, change and delete: good, bad and in the way.
#pragma once

#include <QStringList>
#include <QTemporaryDir>

namespace drillwave {

class MonkeyFiles {
  public:
    MonkeyFiles();

    QString folder() const { return m_folder.path(); }
    /// Names of files that may or may not be there and may hold anything.
    const QStringList& toOpen() const { return m_toOpen; }
    /// Paths to save to: also over others, into a missing folder, over a folder.
    const QStringList& toSave() const { return m_toSave; }
    /// Paths to export to, as files or folders.
    const QStringList& toExport() const { return m_toExport; }
    /// Writes one of them again, spoils it or removes it, as another program would; `choice` from 0.
    void change(int choice);

  private:
    void writeAll();
    void write(const QString& name, const QByteArray& bytes);
    QString path(const QString& name) const { return m_folder.filePath(name); }

    QTemporaryDir m_folder;
    QStringList m_toOpen;
    QStringList m_toSave;
    QStringList m_toExport;
};

}  // namespace drillwave
