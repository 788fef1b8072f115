// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/recovery.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <QUuid>
#include <algorithm>

#include "ui/document/document.h"
#include "ui/document/whole_file.h"
#include "ui/text/shown_text.h"

namespace drillwave {

namespace {

constexpr int format = 1;
constexpr qint64 mostRecordBytes = qint64{256} << 20;  // the largest scenarios of all runs, and signals
const QString recoveryFormatKey = QStringLiteral("drillwave_recovery");
const QString nameKey = QStringLiteral("name");
const QString originKey = QStringLiteral("origin");
const QString timeKey = QStringLiteral("time");
const QString scenarioKey = QStringLiteral("scenario");
const QString pathKey = QStringLiteral("path");
const QString savedKey = QStringLiteral("saved");
const QString runsKey = QStringLiteral("runs");
const QString measuredKey = QStringLiteral("measured");
const QString restartKey = QStringLiteral("restart");
const QString unsavedKey = QStringLiteral("unsaved");

QJsonObject objectOf(const KeptRun& run) {
    QJsonObject object{{QStringLiteral("number"), run.number},
                       {QStringLiteral("name"), QString::fromStdString(run.name)},
                       {scenarioKey, QString::fromStdString(run.contents.text)},
                       {QStringLiteral("source"), QFile::decodeName(run.contents.source.c_str())},
                       {QStringLiteral("shown"), run.isShown},
                       {QStringLiteral("reference"), run.isReference},
                       {QStringLiteral("version"), QString::fromStdString(run.version)}};
    if (run.cor) object.insert(QStringLiteral("cor"), *run.cor);
    return object;
}

// Throws ScenarioError.
KeptRun runOf(const QJsonObject& object) {
    const QJsonValue cor = object[QStringLiteral("cor")];
    return {.number = std::clamp(object[QStringLiteral("number")].toInt(), 0, mostRuns - 1),
            .name = object[QStringLiteral("name")].toString().toStdString(),
            .contents =
                parseScenario(object[scenarioKey].toString().toStdString(),
                              QFile::encodeName(object[QStringLiteral("source")].toString()).toStdString()),
            .isShown = object[QStringLiteral("shown")].toBool(true),
            .isReference = object[QStringLiteral("reference")].toBool(),
            .cor = cor.isDouble() ? std::optional(cor.toDouble()) : std::nullopt,
            .version = object[QStringLiteral("version")].toString().toStdString()};
}

QJsonObject objectOf(const MeasuredSignal& signal) {
    QJsonArray times, forces;
    for (const TablePoint& point : signal.points) {
        times.append(point.time);
        forces.append(point.force);
    }
    return {{nameKey, QString::fromStdString(signal.name)},
            {QStringLiteral("on_rock"), signal.quantity == MeasuredQuantity::impactForce},
            {QStringLiteral("place"), signal.place},
            {QStringLiteral("time_shift"), signal.timeShift},
            {QStringLiteral("deviation"), signal.deviation},
            {QStringLiteral("times"), times},
            {QStringLiteral("forces"), forces}};
}

MeasuredSignal signalOf(const QJsonObject& object) {
    const QJsonArray times = object[QStringLiteral("times")].toArray();
    const QJsonArray forces = object[QStringLiteral("forces")].toArray();
    std::vector<TablePoint> points;
    for (qsizetype i = 0; i < std::min(times.size(), forces.size()); ++i)
        points.push_back({times[i].toDouble(), forces[i].toDouble()});
    MeasuredSignal signal;
    signal.name = object[nameKey].toString().toStdString();
    signal.quantity = object[QStringLiteral("on_rock")].toBool() ? MeasuredQuantity::impactForce
                                                                 : MeasuredQuantity::normalForce;
    signal.place = object[QStringLiteral("place")].toDouble();
    signal.timeShift = object[QStringLiteral("time_shift")].toDouble();
    signal.deviation = object[QStringLiteral("deviation")].toDouble();
    signal.points = std::move(points);
    return signal;
}

void readBeside(const QJsonObject& object, UnsavedScenario& record) {
    for (const QJsonValue& run : object[runsKey].toArray()) {
        try {
            record.beside.runs.push_back(runOf(run.toObject()));
        } catch (const ScenarioError& error) {
            record.problems << run[QStringLiteral("name")].toString() + QStringLiteral(": ") +
                                   translated(error);
        }
    }
    for (const QJsonValue& signal : object[measuredKey].toArray())
        record.beside.measured.push_back(signalOf(signal.toObject()));
}

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
    UnsavedScenario record;
    record.name = object[nameKey].toString();
    record.origin = object[originKey].toString();
    record.path = object[pathKey].toString();
    record.time = QDateTime::fromString(object[timeKey].toString(), Qt::ISODate);
    record.text = scenario.toStdString();
    record.saved = object[savedKey].toString().toStdString();
    record.isRestart = object[restartKey].toBool();
    record.isUnsaved = object[unsavedKey].toBool(true);
    readBeside(object, record);
    return record;
}

QString lockOf(const QString& file) {
    return QFileInfo(file).dir().filePath(QFileInfo(file).completeBaseName() + QStringLiteral(".lock"));
}

// Removes the locks of instances that died with nothing unsaved.
void removeDeadLocks(const QDir& folder) {
    for (const QFileInfo& info : folder.entryInfoList({QStringLiteral("*.lock")}, QDir::Files)) {
        if (folder.exists(info.completeBaseName() + QStringLiteral(".recovery"))) continue;
        QLockFile lock(info.filePath());
        lock.setStaleLockTime(0);
        lock.tryLock();  // unlocking removes it
    }
}

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

QByteArray recoveryBytes(const ScenarioDocument& contents, const UnsavedScenario& record) {
    QJsonArray runs, measured;
    for (const KeptRun& run : record.beside.runs) runs.append(objectOf(run));
    for (const MeasuredSignal& signal : record.beside.measured) measured.append(objectOf(signal));
    const QJsonObject object{{recoveryFormatKey, format},
                             {nameKey, record.name},
                             {originKey, record.origin},
                             {pathKey, record.path},
                             {timeKey, record.time.toString(Qt::ISODate)},
                             {restartKey, record.isRestart},
                             {unsavedKey, record.isUnsaved},
                             {savedKey, QString::fromStdString(record.saved)},
                             {runsKey, runs},
                             {measuredKey, measured},
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
    // Further changes do not restart the timer: the file is written during a drag of minutes, too.
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
