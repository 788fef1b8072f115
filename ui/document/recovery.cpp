// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/recovery.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QUuid>

#include "ui/document/document.h"
#include "ui/document/lost_changes.h"
#include "ui/document/whole_file.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr int delayMilliseconds = 500;

// A name that no other instance has.
QString ownName(const QString& folder) {
    return QDir(folder).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces));
}

QString written(const QString& path, const ScenarioDocument& contents, const UnsavedScenario& record) {
    try {
        return writeWholeFile(path, recoveryBytes(contents, record));
    } catch (const ScenarioError& error) {
        return translated(error);
    }
}

}  // namespace

Recovery::Recovery(const Document& document, const QString& folder, QObject* parent)
    : QObject(parent),
      m_document(document),
      m_file(ownName(folder) + QStringLiteral(".recovery")),
      m_lock(QString(m_file).replace(QStringLiteral(".recovery"), QStringLiteral(".lock"))) {
    QDir().mkpath(folder);
    m_lock.setStaleLockTime(0);
    m_lock.tryLock();
    m_pool.setMaxThreadCount(1);
    m_delay.setSingleShot(true);
    m_delay.setInterval(delayMilliseconds);
    connect(&m_delay, &QTimer::timeout, this, &Recovery::write);
    // Not restarted by the next change: while a slider is dragged for minutes, the file follows.
    connect(&document, &Document::stateChanged, this, &Recovery::writeSoon);
}

void Recovery::writeSoon() {
    if (!m_delay.isActive()) m_delay.start();
}

UnsavedScenario Recovery::record() const {
    UnsavedScenario record;
    record.name = m_document.displayName();
    record.origin = m_document.origin();
    record.path = m_document.path();
    record.time = QDateTime::currentDateTime();
    if (!record.path.isEmpty()) record.saved = m_document.savedText();
    record.beside = m_beside();
    return record;
}

Recovery::~Recovery() {
    m_pool.waitForDone();
}

void Recovery::write() {
    if (m_isWriting.exchange(true)) return m_delay.start();
    if (!m_document.isModified()) {
        m_pool.start([this] {
            QFile::remove(m_file);
            m_isWriting = false;
        });
        return;
    }
    m_pool.start([this, contents = m_document.contents(), record = record()] {
        const QString problem = written(m_file, contents, record);
        if (!problem.isEmpty())
            QMetaObject::invokeMethod(
                this, [this, problem] { report(problem); }, Qt::QueuedConnection);
        m_isWriting = false;
    });
}

void Recovery::report(const QString& problem) {
    if (!std::exchange(m_hasFailed, true)) emit failed(problem);
}

void Recovery::writeNow() {
    m_pool.waitForDone();
    m_delay.stop();
    write();
    m_pool.waitForDone();
}

bool Recovery::writeForRestart() {
    m_delay.stop();
    m_pool.waitForDone();
    UnsavedScenario all = record();
    all.isRestart = true;
    all.isUnsaved = m_document.isModified();
    const QString problem = written(m_file, m_document.contents(), all);
    if (!problem.isEmpty()) report(problem);
    return problem.isEmpty();
}

void Recovery::end() {
    m_delay.stop();
    m_pool.waitForDone();
    QFile::remove(m_file);
}

QString recoveryFolder() {
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
           QStringLiteral("/drillwave/recovery");
}

}  // namespace drillwave
