// Picks between the subcommands, which never need a display, and the window.
#include <QApplication>
#include <QCoreApplication>
#include <algorithm>
#include <clocale>
#include <cstdio>
#include <exception>
#include <initializer_list>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/command.h"
#include "app/help_text.h"
#include "app/window.h"
#include "core/file/scenario_file.h"
#include "core/model/decimal_text.h"
#include "core/model/version.h"

namespace {

using namespace drillwave;

int print(const std::string& text) {
    const bool printed = std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
    return static_cast<int>(printed ? ExitCode::done : ExitCode::unwritableOutput);
}

int printVersion() {
    return print(std::string("drillwave ") + versionText + "\n");
}

const Command* findCommand(const std::string& name) {
    for (const Command* command : commands())
        if (command->name == name) return command;
    return nullptr;
}

bool asksFor(std::span<const std::string> words, std::initializer_list<std::string_view> options) {
    for (const std::string& word : words) {
        if (word == "--") return false;
        if (std::ranges::find(options, word) != options.end()) return true;
    }
    return false;
}

bool asksForHelp(std::span<const std::string> words) {
    return asksFor(words, {"--help", "-h"});
}

/// `drillwave help [COMMAND]`.
int printHelp(std::span<const std::string> words) {
    if (words.empty() || asksForHelp(words)) return print(programHelp());
    if (const Command* command = findCommand(words.front())) return print(commandHelp(*command));
    throw CommandError(ExitCode::usage,
                       "`" + shortened(words.front()) + "` is not a command; `drillwave help` lists them");
}

// The application object takes over the user's locale, and with it a decimal comma in what printf writes.
void writeNumbersPlainly() {
    std::setlocale(LC_NUMERIC, "C");
}

int runCommand(const Command& command, std::span<const std::string> words, int argc, char** argv) {
    if (asksForHelp(words)) return print(commandHelp(command));
    if (asksFor(words, {"--version"})) return printVersion();
    const Arguments arguments = parseArguments(command, words);
    if (!command.draws(arguments)) {
        const QCoreApplication application(argc, argv);
        writeNumbersPlainly();
        return static_cast<int>(command.run(arguments));
    }
    qputenv("QT_QPA_PLATFORM", "offscreen");
    // Qt's remarks on the desktop (no runtime folder, no fonts configured) do not matter to files.
    qInstallMessageHandler([](QtMsgType type, const QMessageLogContext&, const QString& message) {
        if (type == QtFatalMsg) std::fprintf(stderr, "%s\n", message.toUtf8().constData());
    });
    const QApplication application(argc, argv);
    writeNumbersPlainly();
    return static_cast<int>(command.run(arguments));
}

int report(const std::string& who, const CommandError& error) {
    for (const std::string& line : error.lines())
        std::fprintf(stderr, "%s%s\n", error.isLocated() ? "" : who.c_str(), line.c_str());
    return static_cast<int>(error.code());
}

int internalError(const std::string& who, const std::string& what) {
    std::fprintf(stderr, "%sinternal error: %s; please report it with the command that led to it\n",
                 who.c_str(), what.c_str());
    return static_cast<int>(ExitCode::internalError);
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    const Command* command = words.empty() ? nullptr : findCommand(words.front());
    const std::string who = command ? "drillwave " + std::string(command->name) + ": " : "drillwave: ";
    try {
        if (command) return runCommand(*command, std::span(words).subspan(1), argc, argv);
        const std::string first = words.empty() ? std::string() : words.front();
        if (first == "help") return printHelp(std::span(words).subspan(1));
        if (asksForHelp(words)) return print(programHelp());
        if (first == "version" || asksFor(words, {"--version"})) return printVersion();
        return openWindow(argc, argv);
    } catch (const CommandError& error) {
        return report(who, error);
    } catch (const ScenarioError& error) {
        return report(who, CommandError(ExitCode::invalidScenario, error.lines()));
    } catch (const std::bad_alloc&) {
        return internalError(who, "out of memory");
    } catch (const std::exception& error) {
        return internalError(who, error.what());
    }
}
