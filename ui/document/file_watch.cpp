// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/file_watch.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>
#include <QGuiApplication>
#include <algorithm>

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

constexpr std::size_t mostReadings = 64;

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
    m_reported.reset();
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
    } else if (!isThat(m_reported, bytes)) {
        m_reported = bytes;
        emit differs(now);
    }
}

void FileWatch::accept() {
    m_reported = m_accepted = bytesNow(m_path);
}

bool FileWatch::savingNeedsConsent() const {
    if (m_document.path().isEmpty()) return false;
    const QByteArray bytes = bytesNow(m_document.path());
    return compared(bytes, m_document) == State::changed && !isThat(m_accepted, bytes);
}

TableWatch::TableWatch(const Document& document, QObject* parent) : QObject(parent), m_document(document) {
    m_settle.setSingleShot(true);
    m_settle.setInterval(settleMilliseconds);
    connect(&m_settle, &QTimer::timeout, this, &TableWatch::check);
    const auto settle = qOverload<>(&QTimer::start);
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, &m_settle, settle);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, &m_settle, settle);
    connect(&m_document, &Document::replaced, this, [this] { m_readings.clear(); });
    connect(&m_document, &Document::scenarioChanged, this, &TableWatch::follow);
    connect(&m_document, &Document::saved, this, &TableWatch::follow);  // with a name from another folder
    connect(&m_document, &Document::tableRead, this, &TableWatch::remember);
    connect(qGuiApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
        if (state == Qt::ApplicationActive) check();
    });
    follow();
    remember();
}

// A file as old and as large as before is not read again.
TableWatch::Stamp TableWatch::stampOf(const QString& path, const Stamp& before) {
    const QFileInfo info(path);
    if (!info.exists()) return {};
    Stamp stamp{info.size(), info.lastModified(), {}};
    if (stamp.size == before.size && stamp.time == before.time) return before;
    QFile file(path);
    if (stamp.size > largestCompared || !file.open(QIODevice::ReadOnly)) return stamp;
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(&file);
    stamp.digest = hash.result();
    return stamp;
}

bool TableWatch::isSame(const Stamp& a, const Stamp& b) {
    if (a.size != b.size) return false;
    return a.digest.isEmpty() ? a.time == b.time : a.digest == b.digest;
}

// Other points may have come back by undo, from a run or a file: whether theirs is still the same is looked
// at when all has settled.
void TableWatch::follow() {
    const Pulse& pulse = m_document.scenario().pulse;
    const QString path = pulse.shape == PulseShape::table ? m_document.tablePath() : QString();
    if (path == m_path && pulse.tablePoints == m_points) return;
    const bool elsewhere = path != m_path;
    m_path = path;
    m_points = path.isEmpty() ? TablePoints() : pulse.tablePoints;
    m_read = stampOfPoints();
    m_reported.reset();
    if (elsewhere) {
        const QStringList before = m_watcher.files() + m_watcher.directories();
        if (!before.isEmpty()) m_watcher.removePaths(before);
        watch();
    }
    if (path.isEmpty())
        emit agrees();
    else
        m_settle.start();
}

void TableWatch::remember() {
    if (m_path.isEmpty()) return;
    m_read = m_reported = stampOf(m_path, {});
    std::erase_if(m_readings, [this](const Reading& reading) {
        return reading.path == m_path && reading.points == m_points;
    });
    if (m_readings.size() == mostReadings) m_readings.erase(m_readings.begin());
    m_readings.push_back({m_path, m_points, *m_read});
    emit agrees();
}

std::optional<TableWatch::Stamp> TableWatch::stampOfPoints() const {
    const auto found = std::ranges::find_if(m_readings, [this](const Reading& reading) {
        return reading.path == m_path && reading.points == m_points;
    });
    return found == m_readings.end() ? std::nullopt : std::optional(found->stamp);
}

// A file put in the place of another is not watched any more, but its folder is.
void TableWatch::watch() {
    if (m_path.isEmpty()) return;
    if (m_watcher.directories().isEmpty()) m_watcher.addPath(QFileInfo(m_path).absolutePath());
    if (m_watcher.files().isEmpty() && QFile::exists(m_path)) m_watcher.addPath(m_path);
}

void TableWatch::check() {
    watch();
    if (m_path.isEmpty()) return;
    const Stamp now = stampOf(m_path, m_reported.value_or(Stamp()));
    if (m_reported && isSame(now, *m_reported)) return;
    m_reported = now;
    if (m_read && isSame(now, *m_read))
        emit agrees();
    else
        emit differs(now.exists() ? State::changed : State::missing);
}

}  // namespace drillwave
