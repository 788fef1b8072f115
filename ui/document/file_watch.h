// SPDX-License-Identifier: GPL-3.0-or-later
// Watches that report when the document's file is changed by another program.
#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>
#include <optional>
#include <vector>

#include "core/model/scenario.h"

namespace drillwave {

class Document;

/// Time for which a changed file must stay unchanged before it is read [ms], because programs write a file in
/// several steps.
inline constexpr int settleMilliseconds = 200;

/// Watch that notices when another program changes or deletes the document's file. It compares the file's
/// bytes with those last read or written, so that a new time stamp does not count as a change. Also notices
/// files that an editor replaces instead of rewriting. Checks again when the program becomes active, for file
/// systems that report no changes.
class FileWatch : public QObject {
    Q_OBJECT

  public:
    enum class State { same, changed, missing };

    /// Starts watching the document's file. The document must outlive this object.
    explicit FileWatch(const Document& document, QObject* parent = nullptr);

    /// Returns how the scenario file on the disk compares with the document now; `same` if the document has
    /// no file.
    State state() const;
    /// Compares the scenario file with the document. Emits differs() if a new difference is found, and
    /// agrees() if there is none.
    void check();
    /// Accepts the present difference between the file and the document, because the user wants to keep the
    /// document. It is not reported again, and saving needs no confirmation.
    void accept();
    /// Returns true if saving would overwrite a change of the file that the user has not accepted.
    bool savingNeedsConsent() const;

  signals:
    void differs(drillwave::FileWatch::State state);
    /// Emitted if the file agrees with the document. Also emitted when the document gets another file,
    /// because differences of the former file no longer matter.
    void agrees();

  private:
    void follow();
    void forget();

    const Document& m_document;
    QFileSystemWatcher m_watcher;
    QTimer m_settle;  // delay of the check, as editors write in several steps
    QString m_path;
    // File contents last reported as different; a null QByteArray if the file was missing.
    std::optional<QByteArray> m_reported;
    // File contents last accepted by the user; a null QByteArray if the file was missing.
    std::optional<QByteArray> m_accepted;
};

// Watch that reports when the CSV file of a measured hammer force is changed by another program.

/// Watch that notices when another program changes the CSV file with the hammer force of the document. Also
/// notices files that a program replaces instead of rewriting, and checks again when the program becomes
/// active. Compares contents; only for files larger than largestCompared does a new time stamp count as a
/// change.
class TableWatch : public QObject {
    Q_OBJECT

  public:
    /// File size above which contents are not compared [bytes].
    static constexpr qint64 largestCompared = qint64{16} << 20;

    enum class State { changed, missing };

    /// Starts watching the CSV file from which the hammer force of the document is read. The document must
    /// outlive this object.
    explicit TableWatch(const Document& document, QObject* parent = nullptr);

    /// Compares the CSV file with the points that the document has read from it. Emits differs() once for
    /// each change of the file.
    void check();

  signals:
    void differs(drillwave::TableWatch::State state);
    /// Emitted if the CSV file still contains the points that the document has read from it, or if the hammer
    /// force has no CSV file.
    void agrees();

  private:
    /// Fingerprint of a file, which shows whether the file has changed: size, time and digest. The size is −1
    /// if the file does not exist.
    struct Stamp {
        qint64 size = -1;
        QDateTime time;
        QByteArray digest;  // SHA-256 of the contents; empty for a file above largestCompared
        bool exists() const { return size >= 0; }
    };
    static Stamp stampOf(const QString& path, const Stamp& before);
    static bool isSame(const Stamp& a, const Stamp& b);
    /// Points of a hammer force read from a CSV file, with the fingerprint of that file (size, time and
    /// digest) when they were read. It shows later whether the file has changed.
    struct Reading {
        QString path;
        TablePoints points;
        Stamp stamp;
    };
    void follow();
    void remember();
    std::optional<Stamp> stampOfPoints() const;
    void watch();

    const Document& m_document;
    QFileSystemWatcher m_watcher;
    QTimer m_settle;  // delay of the check, as programs write in several steps
    QString m_path;
    TablePoints m_points;
    // Fingerprints for points of the undo history, which undo may restore.
    std::vector<Reading> m_readings;
    // Fingerprint of the file when m_points were read; empty if unknown.
    std::optional<Stamp> m_read;
    std::optional<Stamp> m_reported;
};

}  // namespace drillwave
