// SPDX-License-Identifier: GPL-3.0-or-later
// Picks between the subcommands, which never need a display, and the window.
#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <initializer_list>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "app/command.h"
#include "app/desktop.h"
#include "app/help_text.h"
#include "app/help_topic.h"
#include "app/interruption.h"
#include "app/language_option.h"
#include "app/output_file.h"
#include "core/manual/chapter.h"
#include "core/model/version.h"
#include "core/text/decimal_text.h"
#include "core/text/languages.h"
#include "core/text/name_text.h"
#include "core/yaml/scenario_file.h"

namespace {

using namespace drillwave;

int print(const std::string& text) {
    if (std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0)
        return static_cast<int>(ExitCode::done);
    const std::string reason = std::generic_category().message(errno);
    throw CommandError(ExitCode::unwritableOutput,
                       Message(translatable("standard output: cannot be written: %1"), {reason}));
}

int printVersion() {
    return print(std::string("drillwave ") + versionText + "\n");
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

bool asksForVersion(std::span<const std::string> words) {
    return asksFor(words, {"--version"});
}

/// Words that would be passed over are most likely meant for something else.
void refuseMore(std::span<const std::string> words, std::size_t taken) {
    if (words.size() > taken)
        throw CommandError(ExitCode::usage,
                           Message(translatable("unexpected argument `%1`; see `drillwave help`"),
                                   {shortened(words[taken])}));
}

/// `drillwave version`.
int printVersionAlone(std::span<const std::string> words, const ReadingStyle& style) {
    if (!asksForHelp(words) && !asksForVersion(words)) refuseMore(words, 0);
    return asksForHelp(words) ? print(programHelp(style)) : printVersion();
}

/// As wide as a terminal is, within what can be read; elsewhere as wide as terminals usually are.
std::size_t readableWidth() {
    constexpr std::size_t usual = 80, widest = 110, narrowest = 60;
    winsize size{};
    if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return usual;
    return std::clamp<std::size_t>(size.ws_col, narrowest, widest);
}

/// `drillwave help [TOPIC]` and `drillwave --help [TOPIC]`; TOPIC may be several words.
int printHelp(std::span<const std::string> words, const ReadingStyle& style) {
    std::vector<std::string> topic(words.begin(), words.end());
    std::erase_if(topic, [](const std::string& word) { return word == "--help" || word == "-h"; });
    if (words.empty()) return print(programHelp(style));
    if (topic.empty()) topic.emplace_back("help");
    if (findCommand(topic.front())) refuseMore(topic, 1);
    const std::vector<std::string> chapters = chapterNames();
    if (std::ranges::find(chapters, topic.front()) != chapters.end()) refuseMore(topic, 2);
    return print(topicText(topic, readableWidth(), style));
}

int runCommand(const Command& command, std::span<const std::string> words, const Language& language, int argc,
               char** argv) {
    if (asksForHelp(words)) return print(commandHelp(command, styleOf(language)));
    if (asksForVersion(words)) return printVersion();
    speakOnInterruption(styleOf(language));
    exitOnInterruption();
    const Arguments arguments = parseArguments(command, words, language);
    const std::unique_ptr<const Drawing> drawing =
        command.draws(arguments) ? startDrawing(argc, argv, language) : nullptr;
    useCsvSigns(arguments);
    return static_cast<int>(command.run(arguments, drawing.get()));
}

bool continuesCharacter(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0) == 0x80;
}

/// A message with the middle left out of words of the command line, paths mostly, that would fill the screen.
std::string withShortWords(std::string line, std::span<const std::string> words) {
    constexpr std::size_t longest = 200;
    constexpr std::size_t kept = 60;  // bytes at either end
    for (const std::string& word : words) {
        if (word.size() <= longest) continue;
        std::size_t head = kept;
        std::size_t tail = word.size() - kept;
        while (head > 0 && continuesCharacter(word[head])) --head;
        while (tail < word.size() && continuesCharacter(word[tail])) ++tail;
        const std::string brief = word.substr(0, head) + "…" + word.substr(tail);
        for (std::size_t at = line.find(word); at != std::string::npos;
             at = line.find(word, at + brief.size()))
            line.replace(at, word.size(), brief);
    }
    return line;
}

int report(const std::string& who, const CommandError& error, std::span<const std::string> words,
           const ReadingStyle& style) {
    for (const Message& line : error.messages())
        std::fprintf(stderr, "%s%s\n", error.isLocated() ? "" : who.c_str(),
                     printable(withShortWords(style.said(line), words)).c_str());
    return static_cast<int>(error.code());
}

/// In the place of a closed stream the next file that is opened would get what is meant for that. It gets a
/// file in which what it is for fails.
void occupyClosedStreams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

int internalError(const std::string& who, const Message& what, const ReadingStyle& style) {
    std::fprintf(stderr, "%s%s\n", who.c_str(), style.said(what).c_str());
    return static_cast<int>(ExitCode::internalError);
}

}  // namespace

int main(int argc, char** argv) {
    occupyClosedStreams();
    // A file too large for a limit is an output that cannot be written, in words.
    std::signal(SIGXFSZ, SIG_IGN);
    std::vector<std::string> words(argv + 1, argv + argc);
    std::string who = "drillwave: ";
    const Language* language = &languageOfEnvironment();
    try {
        const bool asksForLanguageOption = words == std::vector<std::string>{"help", languageOption.text()};
        const Language* asked = asksForLanguageOption ? nullptr : takeLanguage(words);
        if (asked) language = asked;
        const ReadingStyle& style = styleOf(*language);
        const std::string first = words.empty() ? std::string() : words.front();
        const std::span behind = std::span<const std::string>(words).subspan(words.empty() ? 0 : 1);
        if (const Command* command = findCommand(first)) {
            who = "drillwave " + first + ": ";
            if (!asked) checkLanguageVariable();
            return runCommand(*command, behind, *language, argc, argv);
        }
        if (first == "help" || first == "--help" || first == "-h") return printHelp(behind, style);
        if (asksForHelp(words)) return print(programHelp(style));
        if (first == "version") return printVersionAlone(behind, style);
        if (asksForVersion(words)) return printVersion();
        return openWindow(argc, argv);
    } catch (const CommandError& error) {
        return report(who, error, words, styleOf(*language));
    } catch (const ScenarioError& error) {
        return report(who, CommandError(ExitCode::invalidScenario, error.messages()), words,
                      styleOf(*language));
    } catch (const std::bad_alloc&) {
        return internalError(
            who,
            translatable(
                "out of memory: this needs more than is free, or than a limit (ulimit -v, -d) permits; raise "
                "it, use fewer threads (-j 1) or ask for less at once"),
            styleOf(*language));
    } catch (const std::exception& error) {
        return internalError(
            who,
            {translatable("internal error: %1; please report it with the command that led to it"),
             {std::string(error.what())}},
            styleOf(*language));
    }
}
