// SPDX-License-Identifier: GPL-3.0-or-later
// Start of programs that measure the window.
#pragma once

#include <unistd.h>
#include <QApplication>
#include <QFile>
#include <QTemporaryDir>
#include <cstdio>
#include <functional>

#include "tests/support/window.h"

namespace drillwave::test {

/// Resident memory of the process.
inline double megabytes() {
    QFile file(QStringLiteral("/proc/self/statm"));
    if (!file.open(QIODevice::ReadOnly)) qFatal("no /proc/self/statm here");
    return file.readAll().split(' ').at(1).toDouble() * double(sysconf(_SC_PAGESIZE)) / 1e6;
}

/// Calls measure(window, count) with a window of the usual size and the count of the command line, `usual`
/// where there is none; without a screen if need be, with settings of its own, and numbers as in files.
/// Returns the exit code.
inline int benchWindow(int argc, char** argv, const char* name, const char* operand, int usual,
                       const std::function<void(MainWindow&, int)>& measure) {
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    const QStringList words = QCoreApplication::arguments();
    const int count = words.size() > 1 ? words.at(1).toInt() : usual;
    if (words.size() > 2 || count < 1) {
        std::fprintf(stderr, "usage: %s [%s]\n", name, operand);
        return 2;
    }
    QLocale::setDefault(QLocale::c());
    const QTemporaryDir settings;
    keepSettingsIn(settings.path());
    MainWindow window;
    window.resize(1440, 900);
    window.show();
    measure(window, count);
    return 0;
}

}  // namespace drillwave::test
