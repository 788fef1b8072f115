// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window.h"

#include <QApplication>
#include <QFileInfo>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "app/command.h"
#include "core/model/version.h"
#include "core/text/decimal_text.h"
#include "core/text/nearest_name.h"
#include "ui/document/recovery.h"
#include "ui/text/settings.h"
#include "ui/window/main_window.h"

namespace drillwave {

namespace {

constexpr const char* noDisplay =
    "no display to open the window on; use `drillwave run FILE` (see --help), or `drillwave -platform "
    "offscreen`";

bool choosesPlatform(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word == "-platform" || word == "--platform" || word.starts_with("-platform=")) return true;
    }
    return !qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM");
}

bool hasDisplay() {
    return !qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY");
}

/// Qt aborts when it finds no platform it can use; this says so in one line.
void onStartupMessage(QtMsgType type, const QMessageLogContext&, const QString& message) {
    if (type != QtFatalMsg) return;
    const std::string reason = message.section('\n', 0, 0).toStdString();
    std::fprintf(
        stderr,
        "drillwave: the window cannot be opened: %s Use `drillwave run FILE` or `-platform offscreen`\n",
        reason.c_str());
    std::_Exit(static_cast<int>(ExitCode::usage));
}

[[noreturn]] void refuseWord(const std::string& word) {
    if (word.size() > 1 && word.starts_with('-'))
        throw CommandError(ExitCode::usage, "unknown option `" + shortened(word) + "`; see drillwave --help");
    std::vector<std::string_view> names;
    for (const Command* command : commands()) names.push_back(command->name);
    const std::string near(nearestName(word, names));
    if (!near.empty())
        throw CommandError(ExitCode::usage,
                           "`" + shortened(word) +
                               "` is neither a command nor a file; did you mean `drillwave " + near + "`?");
    throw CommandError(ExitCode::unreadableInput, word + ": No such file or command; see drillwave --help");
}

/// What the command line asks of the window.
struct WindowArguments {
    QString file;  ///< to open, empty without
    bool resetsUi = false;
};

WindowArguments windowArguments(const QStringList& words) {
    WindowArguments arguments;
    for (const QString& word : words.mid(1)) {
        if (word == QLatin1String("--reset-ui")) {
            arguments.resetsUi = true;
            continue;
        }
        if (!QFileInfo::exists(word)) refuseWord(word.toStdString());
        if (!arguments.file.isEmpty())
            throw CommandError(ExitCode::usage, "`" + shortened(word.toStdString()) +
                                                    "` is too much; the window opens one file");
        arguments.file = word;
    }
    return arguments;
}

}  // namespace

int openWindow(int argc, char** argv) {
    if (!choosesPlatform(argc, argv) && !hasDisplay()) {
        // Mistyped commands are worth more than the missing display.
        QStringList words;
        for (int i = 0; i < argc; ++i) words.append(QString::fromLocal8Bit(argv[i]));
        windowArguments(words);
        throw CommandError(ExitCode::usage, noDisplay);
    }
    const QtMessageHandler usual = qInstallMessageHandler(onStartupMessage);
    QApplication application(argc, argv);
    qInstallMessageHandler(usual);
    QCoreApplication::setApplicationName("Drillwave");
    QCoreApplication::setOrganizationName("Drillwave");
    QCoreApplication::setApplicationVersion(versionText);

    const WindowArguments arguments = windowArguments(QCoreApplication::arguments());
    if (arguments.resetsUi) resetSettings();
    MainWindow window;
    window.show();
    if (!arguments.file.isEmpty()) window.openFile(arguments.file);
    window.startRecovery(recoveryFolder());
    return QApplication::exec();
}

}  // namespace drillwave
