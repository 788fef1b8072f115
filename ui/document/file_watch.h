// SPDX-License-Identifier: GPL-3.0-or-later
// Watches of files: whether the document's file still has the contents last read from it or written to it.
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

/// How long a file must stay unchanged before it is read [ms].
inline constexpr int settleMilliseconds = 200;

/// Watches the file of the document, also through editors that put a new file in its place, and looks again
/// whenever the program becomes active, for file systems that report nothing. Compares bytes: saving from
/// here or touching the file is no change.
class FileWatch : public QObject {
    Q_OBJECT

  public:
    enum class State { same, changed, missing };

    /// The document must outlive the watch.
    explicit FileWatch(const Document& document, QObject* parent = nullptr);

    /// Looks at the file now. A document without a file is `same`.
    State state() const;
    /// Compares the file and emits differs() for a difference that was not reported yet, or agrees().
    void check();
    /// Accepts the present difference: it is not reported again and saving needs no consent.
    void accept();
    /// Whether saving would write over something that nobody here has seen and accepted.
    bool savingNeedsConsent() const;

  signals:
    void differs(drillwave::FileWatch::State state);
    /// There is no difference, or none is known for a file that is new here.
    void agrees();

  private:
    void follow();
    void forget();

    const Document& m_document;
    QFileSystemWatcher m_watcher;
    QTimer m_settle;  // editors write in several steps
    QString m_path;
    std::optional<QByteArray> m_reported;  // bytes of the difference reported last; null when missing
    std::optional<QByteArray> m_accepted;  // bytes of the difference accepted last; null when missing
};

// Whether the file of a measured blow still has the contents that were read from it.

/// Watches the CSV file that the hammer blow of the document is from, also through programs that put a new
/// file in its place, and looks again whenever the program becomes active. Compares contents: touching the
/// file is no change, unless it is larger than largestCompared.
class TableWatch : public QObject {
    Q_OBJECT

  public:
    static constexpr qint64 largestCompared = qint64{16} << 20;  ///< [bytes]

    enum class State { changed, missing };

    /// The document must outlive the watch.
    explicit TableWatch(const Document& document, QObject* parent = nullptr);

    /// Compares the file and emits differs() once per change since the points on show were read.
    void check();

  signals:
    void differs(drillwave::TableWatch::State state);
    /// There is no table file, or the points on show were read from it.
    void agrees();

  private:
    /// Fingerprint of a file; empty if there is no file.
    struct Stamp {
        qint64 size = -1;
        QDateTime time;
        QByteArray digest;  // empty for a large file
        bool exists() const { return size >= 0; }
    };
    static Stamp stampOf(const QString& path, const Stamp& before);
    static bool isSame(const Stamp& a, const Stamp& b);
    /// Fingerprint of a file when its points were read.
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
    QTimer m_settle;  // programs write in several steps
    QString m_path;
    TablePoints m_points;
    std::vector<Reading> m_readings;  // of the present history, to which points may come back
    std::optional<Stamp> m_read;      // of the file m_points are from, where that is known
    std::optional<Stamp> m_reported;
};

}  // namespace drillwave
