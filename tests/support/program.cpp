// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/program.h"

#include <QDeadlineTimer>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QProcess>
#include <QThread>

namespace drillwave::test {

namespace {

Finished finish(QProcess& process) {
    if (!process.waitForFinished(60000)) {
        process.kill();
        process.waitForFinished();
        return {};
    }
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
            process.readAllStandardOutput(), process.readAllStandardError()};
}

}  // namespace

Finished run(const QStringList& words, const QProcessEnvironment& environment) {
    QProcess process;
    process.setProcessEnvironment(environment);
    process.start(QStringLiteral(DRILLWAVE_PROGRAM), words);
    return finish(process);
}

QByteArray output(const QStringList& words) {
    const Finished finished = run(words);
    if (finished.exitCode != 0) qFatal("%s", finished.error.constData());
    return finished.out;
}

QList<QList<QByteArray>> rowsOf(const QByteArray& csv) {
    QList<QList<QByteArray>> rows;
    for (const QByteArray& line : csv.trimmed().split('\n'))
        if (!line.startsWith('#')) rows << line.split(',');
    return rows;
}

Finished shell(const QString& line, const QString& folder) {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    const QString programs = QFileInfo(QStringLiteral(DRILLWAVE_PROGRAM)).path();
    environment.insert(QStringLiteral("PATH"), programs + QLatin1Char(':') + environment.value("PATH"));
    // The shell itself would complain of a locale that is not installed.
    const QString own = QStringLiteral("drillwave() { env LC_ALL='%1' drillwave \"$@\"; }\n")
                            .arg(environment.value(QStringLiteral("LC_ALL")));
    environment.remove(QStringLiteral("LC_ALL"));
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(folder);
    process.start(QStringLiteral("bash"), {QStringLiteral("-c"), own + line});
    return finish(process);
}

const QJsonObject json(const QStringList& words) {
    const Finished finished = run(words + QStringList{"--json"});
    if (finished.exitCode != 0) qFatal("%s", finished.error.constData());
    return QJsonDocument::fromJson(finished.out).object();
}

bool waitForThreads(const QProcess& process, int least) {
    const QDir threads(QStringLiteral("/proc/%1/task").arg(process.processId()));
    for (QDeadlineTimer minute(60000); !minute.hasExpired(); QThread::msleep(2))
        if (threads.entryList(QDir::Dirs | QDir::NoDotAndDotDot).size() >= least) return true;
    return false;
}

QString example(const QString& name) {
    return QStringLiteral(DRILLWAVE_SOURCE_DIR "/resources/examples/") + name + QStringLiteral(".yaml");
}

}  // namespace drillwave::test
