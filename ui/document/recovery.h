// SPDX-License-Identifier: GPL-3.0-or-later
// Unsaved changes kept on disk while the program runs, for the case that it ends unexpectedly.
#pragma once

#include <QLockFile>
#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <atomic>
#include <functional>
#include <memory>

#include "ui/document/lost_changes.h"

namespace drillwave {

class Document;

/// Writes the unsaved scenario of a document to a file of its own in `folder` within a second of a change,
/// away from the window's thread, whole or not at all, and removes it when there is nothing unsaved. A lock
/// beside the file tells other instances that this one is alive.
class Recovery : public QObject {
    Q_OBJECT

  public:
    /// Makes the folder. The document must outlive the recovery.
    Recovery(const Document& document, const QString& folder, QObject* parent = nullptr);
    /// Leaves the file where it is; call end() first where nothing is to be recovered.
    ~Recovery() override;

    /// Keeps with the scenario what `beside` returns.
    void keepBeside(std::function<WorkBeside()> beside) { m_beside = std::move(beside); }
    /// Something beside the document has changed.
    void writeSoon();
    /// Writes what is unsaved and returns when it is on the disk.
    void writeNow();
    /// Writes everything, unsaved or not, for a window that takes its place and asks nothing. False where
    /// that has failed.
    bool writeForRestart();
    /// Nothing is to be recovered any more: removes the file. A further change starts anew.
    void end();
    QString file() const { return m_file; }

  signals:
    /// Changes cannot be kept, told once: why.
    void failed(const QString& problem);

  private:
    void write();
    UnsavedScenario record() const;
    void report(const QString& problem);

    const Document& m_document;
    std::function<WorkBeside()> m_beside = [] { return WorkBeside(); };
    QString m_file;
    QLockFile m_lock;
    QTimer m_delay;
    QThreadPool m_pool;
    std::atomic<bool> m_isWriting = false;
    bool m_hasFailed = false;
};

/// The folder in which every instance of the program keeps its unsaved changes.
QString recoveryFolder();

}  // namespace drillwave
