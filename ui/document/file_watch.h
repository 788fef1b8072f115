// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the document's file still says what was read from it or written to it last.
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>
#include <optional>

namespace drillwave {

class Document;

/// How long a file must be left alone after a change before it is read [ms].
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
    /// Looks, and tells what is new since it was told last.
    void check();
    /// The present difference is meant to be: it is neither told again nor in the way of saving.
    void accept();
    /// Whether saving would write over something that nobody here has seen and accepted.
    bool savingNeedsConsent() const;

  signals:
    void differs(drillwave::FileWatch::State state);
    /// There is no difference, or none that is known of a file that is new here.
    void agrees();

  private:
    void follow();
    void forget();

    const Document& m_document;
    QFileSystemWatcher m_watcher;
    QTimer m_settle;  // editors write in several steps
    QString m_path;
    std::optional<QByteArray> m_told;      // bytes of the difference told last; null when missing
    std::optional<QByteArray> m_accepted;  // likewise
};

}  // namespace drillwave
