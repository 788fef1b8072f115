// SPDX-License-Identifier: GPL-3.0-or-later
// What programs that measure the window begin with.
#pragma once

#include <QApplication>
#include <QTemporaryDir>
#include <cstdio>
#include <functional>

#include "tests/support/window.h"

namespace drillwave::test {

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
