// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/file_watch.h"

#include <QFile>
#include <QFileInfo>
#include <QGuiApplication>

#include "ui/document/document.h"

namespace drillwave {
namespace {

constexpr qint64 mostComparedBytes =
    (qint64{1} << 20) + 1;  // a larger one is no scenario file, so it differs

// Null when the file is gone, empty but not null when there is nothing in it.
QByteArray bytesNow(const QString& path) {
    QFile file(path);
    if (!file.exists()) return {};
    const QByteArray bytes = file.open(QIODevice::ReadOnly) ? file.read(mostComparedBytes) : QByteArray();
    return bytes.isNull() ? QByteArray("") : bytes;
}

FileWatch::State compared(const QByteArray& bytes, const Document& document) {
    if (bytes.isNull()) return FileWatch::State::missing;
    return bytes == QByteArrayView(document.savedText()) ? FileWatch::State::same : FileWatch::State::changed;
}

bool isThat(const std::optional<QByteArray>& known, const QByteArray& bytes) {
    return known && known->isNull() == bytes.isNull() && *known == bytes;
}

}  // namespace

FileWatch::FileWatch(const Document& document, QObject* parent) : QObject(parent), m_document(document) {
    m_settle.setSingleShot(true);
    m_settle.setInterval(settleMilliseconds);
    connect(&m_settle, &QTimer::timeout, this, &FileWatch::check);
    const auto settle = qOverload<>(&QTimer::start);
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, &m_settle, settle);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, &m_settle, settle);
    connect(&m_document, &Document::stateChanged, this, &FileWatch::follow);
    connect(&m_document, &Document::replaced, this, &FileWatch::forget);
    connect(qGuiApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
        if (state == Qt::ApplicationActive) check();
    });
    follow();
}

// A file put in the place of another is not watched any more, but its folder is.
void FileWatch::follow() {
    if (m_path != m_document.path()) {
        const QStringList before = m_watcher.files() + m_watcher.directories();
        if (!before.isEmpty()) m_watcher.removePaths(before);
        m_path = m_document.path();
        forget();
        if (!m_path.isEmpty()) m_watcher.addPath(QFileInfo(m_path).absolutePath());
    }
    if (!m_path.isEmpty() && m_watcher.files().isEmpty() && QFile::exists(m_path)) m_watcher.addPath(m_path);
}

void FileWatch::forget() {
    m_told.reset();
    m_accepted.reset();
    emit agrees();
}

FileWatch::State FileWatch::state() const {
    if (m_document.path().isEmpty()) return State::same;
    return compared(bytesNow(m_document.path()), m_document);
}

void FileWatch::check() {
    follow();
    if (m_path.isEmpty()) return;
    const QByteArray bytes = bytesNow(m_path);
    const State now = compared(bytes, m_document);
    if (now == State::same) {
        forget();
    } else if (!isThat(m_told, bytes)) {
        m_told = bytes;
        emit differs(now);
    }
}

void FileWatch::accept() {
    m_told = m_accepted = bytesNow(m_path);
}

bool FileWatch::savingNeedsConsent() const {
    if (m_document.path().isEmpty()) return false;
    const QByteArray bytes = bytesNow(m_document.path());
    return compared(bytes, m_document) == State::changed && !isThat(m_accepted, bytes);
}

}  // namespace drillwave
