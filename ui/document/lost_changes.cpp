// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/lost_changes.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

#include "ui/text/translation.h"

namespace drillwave {
namespace {

constexpr int format = 1;
constexpr qint64 mostRecordBytes = qint64{8} << 20;  // the largest scenario with every byte escaped
const QString recoveryFormatKey = QStringLiteral("drillwave_recovery");
const QString nameKey = QStringLiteral("name");
const QString originKey = QStringLiteral("origin");
const QString timeKey = QStringLiteral("time");
const QString scenarioKey = QStringLiteral("scenario");

// The scenario, or an empty text with the reason.
UnsavedScenario readRecovery(const QString& path, QString& problem) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        problem = file.errorString();
        return {};
    }
    const QJsonObject object = QJsonDocument::fromJson(file.read(mostRecordBytes)).object();
    const QString scenario = object[scenarioKey].toString();
    if (object[recoveryFormatKey].toInt() != format || scenario.isEmpty()) {
        problem = tr("it is damaged, or written by another version of the program");
        return {};
    }
    return {object[nameKey].toString(), object[originKey].toString(),
            QDateTime::fromString(object[timeKey].toString(), Qt::ISODate), scenario.toStdString()};
}

QString lockOf(const QString& file) {
    return QFileInfo(file).dir().filePath(QFileInfo(file).completeBaseName() + QStringLiteral(".lock"));
}

// Of instances that died with nothing unsaved.
void removeDeadLocks(const QDir& folder) {
    for (const QFileInfo& info : folder.entryInfoList({QStringLiteral("*.lock")}, QDir::Files)) {
        if (folder.exists(info.completeBaseName() + QStringLiteral(".recovery"))) continue;
        QLockFile lock(info.filePath());
        lock.setStaleLockTime(0);
        lock.tryLock();  // unlocking removes it
    }
}

}  // namespace

QByteArray recoveryBytes(const ScenarioDocument& contents, const QString& name, const QString& origin,
                         const QDateTime& time) {
    const QJsonObject object{{recoveryFormatKey, format},
                             {nameKey, name},
                             {originKey, origin},
                             {timeKey, time.toString(Qt::ISODate)},
                             {scenarioKey, QString::fromStdString(writeScenario(contents))}};
    return QJsonDocument(object).toJson();
}

LostChanges::LostChanges(const QString& file, std::unique_ptr<QLockFile> lock)
    : m_file(file), m_lock(std::move(lock)) {
    m_scenario = readRecovery(file, m_problem);
}

void LostChanges::discard() {
    QFile::remove(m_file);
}

QString LostChanges::setAside() {
    const QString name = QFileInfo(m_file).path() + QLatin1Char('/') + QFileInfo(m_file).completeBaseName() +
                         QStringLiteral(".damaged");
    return QFile::rename(m_file, name) ? name : m_file;
}

std::vector<LostChanges> findLostChanges(const QString& folder) {
    const QDir directory(folder);
    std::vector<LostChanges> all;
    removeDeadLocks(directory);
    for (const QFileInfo& info : directory.entryInfoList({QStringLiteral("*.recovery")}, QDir::Files)) {
        auto lock = std::make_unique<QLockFile>(lockOf(info.filePath()));
        lock->setStaleLockTime(0);  // however long it runs, an instance is alive as long as its process is
        if (lock->tryLock()) all.emplace_back(info.filePath(), std::move(lock));
    }
    std::ranges::stable_sort(all, std::ranges::greater(),
                             [](const LostChanges& lost) { return lost.scenario().time; });
    return all;
}

}  // namespace drillwave
