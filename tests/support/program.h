// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the program that was built, as a shell would.
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

/// Result of running the program: its exit code and output.
struct Finished {
    int exitCode = -1;  ///< exit code; −1 if it did not end within a minute
    QByteArray out;
    QByteArray error;
};

Finished run(const QStringList& words,
             const QProcessEnvironment& environment = QProcessEnvironment::systemEnvironment());

/// Returns what the program prints with these arguments; ends the test if it fails.
QByteArray output(const QStringList& words);

/// Returns the cells of a CSV text without quotes, row by row, leaving out comment lines ("#").
QList<QList<QByteArray>> rowsOf(const QByteArray& csv);

/// Runs a line in a shell in that folder, where `drillwave` is the built program, and returns the result.
Finished shell(const QString& line, const QString& folder = QDir::tempPath());

/// Returns the JSON object that the program prints with these arguments and --json; ends the test if it
/// fails. It is constant so that its operator[] never adds a key.
const QJsonObject json(const QStringList& words);

/// Waits until a started program has at least `least` threads: one of two waits for signals, further ones
/// compute. Returns false if that takes over a minute.
bool waitForThreads(const QProcess& process, int least);

/// Returns the path of a file in resources/examples.
QString example(const QString& name);

}  // namespace drillwave::test
