// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the built program as a shell would.
#pragma once

#include <QByteArray>
#include <QDir>
#include <QJsonObject>
#include <QProcess>
#include <QProcessEnvironment>
#include <QString>
#include <QStringList>

#include "tests/support/files.h"

namespace drillwave::test {

/// Result of a run of the program.
struct Finished {
    int exitCode = -1;  ///< −1 when it did not end by itself in a minute
    QByteArray out;
    QByteArray error;
};

Finished run(const QStringList& words,
             const QProcessEnvironment& environment = QProcessEnvironment::systemEnvironment());

/// Returns the output of `words`; the test ends where that fails.
QByteArray output(const QStringList& words);

/// The cells of a CSV without quotes, line by line, without its "#" lines.
QList<QList<QByteArray>> rowsOf(const QByteArray& csv);

/// A line for a shell in that folder that finds the built program as `drillwave`, as people paste it.
Finished shell(const QString& line, const QString& folder = QDir::tempPath());

/// Returns the output of `words --json`; the test ends where that fails. Constant, so that its [] never adds.
const QJsonObject json(const QStringList& words);

/// Waits until a started program runs so many threads: with two, the one that waits for signals is there and
/// the work begins; further ones work. False when that takes over a minute.
bool waitForThreads(const QProcess& process, int least);

/// Path of a file of resources/examples.
QString example(const QString& name);

}  // namespace drillwave::test
