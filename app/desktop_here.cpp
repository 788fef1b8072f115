// SPDX-License-Identifier: GPL-3.0-or-later
// The program that is linked to the library of the desktop.
#include "app/desktop.h"

#include <pwd.h>
#include <unistd.h>

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QFontMetrics>
#include <QLocale>
#include <QTemporaryDir>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "app/command_error.h"
#include "app/interruption.h"
#include "app/language_option.h"
#include "app/open_files.h"
#include "app/window_arguments.h"
#include "core/model/version.h"
#include "ui/document/recovery.h"
#include "ui/export/figure_plot.h"
#include "ui/export/plot_export.h"
#include "ui/export/report_export.h"
#include "ui/export/study_pictures.h"
#include "ui/text/language.h"
#include "ui/text/number_text.h"
#include "ui/text/settings.h"
#include "ui/text/shown_text.h"
#include "ui/window/main_window.h"
#include "ui/window/program_icon.h"

namespace drillwave {

namespace {

constexpr const char* noDisplay = translatable(
    "no display to open the window on; use `drillwave run FILE` (see --help), or `drillwave -platform "
    "offscreen`");

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

/// The displays that the session names: ":77", "wayland-0, :77"; empty without.
std::string namedDisplays() {
    std::string names;
    for (const char* variable : {"WAYLAND_DISPLAY", "DISPLAY"})
        if (const std::string name = qgetenv(variable).toStdString(); !name.empty())
            names += (names.empty() ? "" : ", ") + name;
    return names;
}

/// Why the window cannot be opened, prepared for onStartupMessage(), which is given no words of its own.
std::string lineOfFailure;

void prepareFailure(bool isPlatformChosen) {
    const ReadingStyle& style = styleOf(languageOfEnvironment());
    lineOfFailure =
        "drillwave: " +
        style.said(
            isPlatformChosen
                ? Message(translatable("the window cannot be opened on the platform of -platform or "
                                       "QT_QPA_PLATFORM; use `drillwave run FILE` or `-platform offscreen`"))
                : Message(
                      translatable("display %1 cannot be reached; set DISPLAY to an available one, use "
                                   "`drillwave run FILE` (see --help), or `drillwave -platform offscreen`"),
                      {namedDisplays()})) +
        "\n";
}

/// Prints one line when Qt finds no platform it can use, before it aborts.
void onStartupMessage(QtMsgType type, const QMessageLogContext&, const QString&) {
    if (type != QtFatalMsg) return;
    std::fputs(lineOfFailure.c_str(), stderr);
    std::_Exit(static_cast<int>(ExitCode::usage));
}

QtMessageHandler usualHandler = nullptr;

/// Drops the messages of the platform without a display about its limits.
void onWindowMessage(QtMsgType type, const QMessageLogContext& context, const QString& message) {
    if (!message.startsWith(QLatin1String("This plugin does not support")))
        usualHandler(type, context, message);
}

bool isHome(const QString& path) {
    return !path.isEmpty() && QFileInfo(path).isDir();
}

/// Gives a session without a home folder one, or Qt would make folders in the root of the disk, or in the
/// missing HOME: that of the user if HOME is not set, else one that is removed with the window.
class Home {
  public:
    Home() {
        if (isHome(qEnvironmentVariable("HOME"))) return;
        const passwd* user = ::getpwuid(::geteuid());
        QString home =
            user && !qEnvironmentVariableIsSet("HOME") ? QString::fromLocal8Bit(user->pw_dir) : QString();
        if (!isHome(home))
            home = m_folder.emplace(QDir::tempPath() + QStringLiteral("/drillwave-XXXXXX")).path();
        qputenv("HOME", QFile::encodeName(home));
    }

  private:
    std::optional<QTemporaryDir> m_folder;
};

/// The words that Qt has left, without the name of the program.
WindowArguments wordsFor(const QStringList& words) {
    std::vector<std::string> plain;
    for (const QString& word : words.mid(1)) plain.push_back(word.toStdString());
    return windowArguments(plain);
}

// Undoes the user's locale, which the application object sets: printf would write decimal commas, and
// messages of the system would have another language than the sentences around them.
void writePlainly() {
    std::setlocale(LC_NUMERIC, "C");
    std::setlocale(LC_MESSAGES, "C");
}

/// Qt looks for a desktop even on the platform that needs none, and makes a folder for its sockets if the
/// session names none (XDG_RUNTIME_DIR). Removes it, unless it existed before or is not empty.
class RuntimeFolder {
  public:
    RuntimeFolder() : m_wasThere(QFileInfo::exists(path())) {}
    ~RuntimeFolder() {
        if (!m_wasThere) QDir().rmdir(path());
    }
    RuntimeFolder(const RuntimeFolder&) = delete;
    RuntimeFolder& operator=(const RuntimeFolder&) = delete;

  private:
    static QString path() {
        const passwd* user = ::getpwuid(::geteuid());
        return QDir::tempPath() + QStringLiteral("/runtime-") +
               (user ? QString::fromLocal8Bit(user->pw_name) : QString());
    }

    bool m_wasThere;
};

class QtDrawing : public Drawing {
  public:
    QtDrawing(int argc, char** argv, const Language& language) : m_argc(argc), m_application(m_argc, argv) {
        if (isEnglish(language)) return;
        speak(language);
        m_reader.locale = withoutGroups(QLocale(fromView(language.code)));
        m_reader.isSpokenTo = true;
    }

    std::string figure(const Figure& figure, std::string_view format) const override {
        return drawFigure(figure, fromView(format)).toStdString();
    }

    std::vector<NamedFile> blow(const Blow& blow, const std::vector<std::string>& formats,
                                const std::stop_token& stop) const override {
        return filesOf(drawBlowPlots(blow, formats, stop, m_reader));
    }

    std::vector<NamedFile> report(const BlowReport& report, const PictureOrder& order) const override {
        return filesOf(drawReport(report, order, m_reader));
    }

    std::vector<NamedFile> study(const StudyValue& value, const PictureOrder& order) const override {
        return std::visit([&](const auto* found) { return filesOf(drawStudy(*found, order, m_reader)); },
                          value);
    }

  private:
    static std::vector<NamedFile> filesOf(Pictures pictures) {
        if (!pictures.problem.isEmpty())
            throw CommandError(ExitCode::unwritableOutput, pictures.problem.toStdString());
        return std::move(pictures.files);
    }

    int m_argc;  // outlives the application, which refers to it
    QApplication m_application;
    PaperReader m_reader;
};

}  // namespace

int openWindow(int argc, char** argv) {
    if (!choosesPlatform(argc, argv) && !hasDisplay()) {
        // Mistyped commands are worth more than the missing display.
        windowArguments(std::vector<std::string>(argv + 1, argv + argc));
        throw CommandError(ExitCode::usage, noDisplay);
    }
    const Home home;
    prepareFailure(choosesPlatform(argc, argv));
    usualHandler = qInstallMessageHandler(onStartupMessage);
    QApplication application(argc, argv);
    qInstallMessageHandler(onWindowMessage);
    QCoreApplication::setApplicationName("Drillwave");
    QCoreApplication::setOrganizationName("Drillwave");
    QCoreApplication::setApplicationVersion(versionText);
    // A desktop identifies the window by its entry in the menu.
    QGuiApplication::setDesktopFileName("drillwave");
    QGuiApplication::setWindowIcon(programIcon());

    QLocale::setDefault(withoutGroups(QLocale()));
    const WindowArguments arguments = wordsFor(QCoreApplication::arguments());
    if (arguments.resetsUi) resetSettings();
    for (bool isFirst = true;; isFirst = false) {
        speak(isFirst && arguments.language ? *arguments.language : languageToSpeak());
        MainWindow window;
        window.show();
        if (isFirst && !arguments.file.empty()) window.openFile(QString::fromStdString(arguments.file));
        if (isFirst && arguments.example) window.openExample(*arguments.example);
        window.startRecovery(recoveryFolder());
        const int code = QApplication::exec();
        if (!window.wantsRestart()) return code;
    }
}

std::unique_ptr<const Drawing> startDrawing(int argc, char** argv, const Language& language) {
    // Qt ends the program where it cannot open its plugins and fonts.
    constexpr int filesOfQt = 16;
    checkOpenFiles(filesOfQt);
    qputenv("QT_QPA_PLATFORM", "offscreen");
    // Qt's remarks on the desktop (no runtime folder, no fonts configured) do not matter to files.
    qInstallMessageHandler([](QtMsgType type, const QMessageLogContext&, const QString& message) {
        if (type == QtFatalMsg) std::fprintf(stderr, "%s\n", message.toUtf8().constData());
    });
    // A signal now would leave that folder.
    const HeldInterruptions held;
    const RuntimeFolder runtimeFolder;
    auto drawing = std::make_unique<const QtDrawing>(argc, argv, language);
    writePlainly();
    // Qt names families that it has no fonts for.
    if (!QFontMetrics(QApplication::font()).inFont(QLatin1Char('a')))
        throw CommandError(
            ExitCode::unwritableOutput,
            translatable("there are no fonts for the letters of the pictures; install some "
                         "(Debian: apt install fonts-dejavu-core), or leave out the pictures"));
    return drawing;
}

}  // namespace drillwave
