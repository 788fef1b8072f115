// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the runs in a folder beside the scenario file, where the user wants that.
#pragma once

#include <QObject>
#include <QTimer>

#include "ui/document/document.h"
#include "ui/runs/runs.h"

namespace drillwave {

/// A scenario that is opened brings the runs of its folder with it; those of the scenario before go where
/// they are kept, and stay beside the new ones where nothing else has them. While runs are kept, every change
/// of them is written, and after "save as" beside the new file, where there are no others.
class RunKeeper : public QObject {
    Q_OBJECT

  public:
    /// Document and runs must outlive it.
    RunKeeper(Document& document, Runs& runs, QObject* parent = nullptr);
    /// Writes what has not been written yet; a failure is told to nobody, who may be gone already.
    ~RunKeeper() override;

    bool isKept() const { return m_kept; }
    /// The folder of the present scenario; empty where that has no file.
    QString folder() const;
    /// The files that are there but not of the runs on show, and would stay: to be asked about first.
    bool holdsOthers() const;
    /// From now on, and now. Returns why not; then nothing is kept.
    /// What somebody else has put there is replaced only if that is asked for.
    QString keep(ExistingFiles existing = ExistingFiles::kept);
    /// From now on no more; takes the files of the runs, but for those that somebody else has changed, and
    /// the folder where nothing else is in it, away.
    void giveUp();

  signals:
    void keptChanged(bool kept);
    /// Saved under a name beside which this folder is already: nothing is kept there until keep() is called.
    void othersFound(const QString& folder);
    /// Some runs could not be taken from their files, or not be written: why, line by line.
    void failed(const QString& what, const QString& problem);

  private:
    void leave();
    void read();
    void followSaved();
    bool isForeign(const std::string& name) const;
    std::string foreignFile() const;
    std::vector<NamedFile> files() const;
    void leaveOutWritten(std::vector<NamedFile>& files) const;
    void writeSoon();
    void writeNow();
    QString write(ExistingFiles existing);
    void setKept(bool kept);

    Document& m_document;
    Runs& m_runs;
    QTimer m_due;
    QString m_path;  // of the scenario file whose folder it is
    bool m_kept = false;
    bool m_partial = false;          // not all that is in the folder is on show
    std::vector<NamedFile> m_files;  // of the folder that are ours, as they are there
};

}  // namespace drillwave
