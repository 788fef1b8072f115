// SPDX-License-Identifier: GPL-3.0-or-later
// Starts a test program again as a child process, to kill it during its work.
#pragma once

#include <QCoreApplication>
#include <QProcess>
#include <cstdio>

namespace drillwave {

/// Tells the parent process, on standard output, that the child is ready.
inline void sayReady() {
    std::puts("ready");
    std::fflush(stdout);
}

/// Starts this program again with these arguments and waits until it reports that it is ready. Returns false
/// if that takes longer than a minute.
inline bool startChild(QProcess& child, const QStringList& words) {
    child.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    // By argv[0] instead of the file, which may contain many tests: the name selects this one.
    child.start(QCoreApplication::arguments().constFirst(), words);
    while (child.waitForReadyRead(60000))
        if (child.readAllStandardOutput().contains("ready")) return true;
    return false;
}

/// Kills the child by SIGKILL, which it cannot catch. Returns true if it has ended by that.
inline bool killChild(QProcess& child) {
    child.kill();
    return child.waitForFinished() && child.exitStatus() == QProcess::CrashExit;
}

}  // namespace drillwave
