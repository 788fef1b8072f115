// SPDX-License-Identifier: GPL-3.0-or-later
// A test program that runs itself as a child, to be killed in the middle of its work.
#pragma once

#include <QCoreApplication>
#include <QProcess>
#include <cstdio>

namespace drillwave {

/// Reports to the parent that the child is ready.
inline void sayReady() {
    std::puts("ready");
    std::fflush(stdout);
}

/// Starts this program again with these words and returns once it reports that it is ready. False if that
/// takes longer than a minute.
inline bool startChild(QProcess& child, const QStringList& words) {
    child.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    // Not the file, which may have many tests: the name selects this one.
    child.start(QCoreApplication::arguments().constFirst(), words);
    while (child.waitForReadyRead(60000))
        if (child.readAllStandardOutput().contains("ready")) return true;
    return false;
}

/// Kills it as nothing can be caught: SIGKILL.
inline bool killChild(QProcess& child) {
    child.kill();
    return child.waitForFinished() && child.exitStatus() == QProcess::CrashExit;
}

}  // namespace drillwave
