// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/interruption.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <string>
#include <system_error>

#include "app/open_files.h"

namespace drillwave {

namespace {

// Requesting a stop takes locks, which a signal handler may not: it writes a byte that a thread is waiting
// for.
int wakeUp[2] = {-1, -1};
/// A signal handler cannot look for words.
std::string lineOfInterruption = "drillwave: interrupted\n";
const ReadingStyle* styleOfCommand = nullptr;
constexpr char interrupted = 'i';
constexpr char ended = 'e';

void send(char byte) {
    const int saved = errno;
    [[maybe_unused]] const auto written = ::write(wakeUp[1], &byte, 1);
    errno = saved;
}

void onSignal(int) {
    send(interrupted);
}

void exitAtOnce(int) {
    [[maybe_unused]] const auto written =
        ::write(STDERR_FILENO, lineOfInterruption.data(), lineOfInterruption.size());
    ::_exit(static_cast<int>(ExitCode::interrupted));
}

constexpr std::array interruptions{SIGINT, SIGTERM, SIGHUP};

sigset_t interruptionSet() {
    sigset_t set;
    sigemptyset(&set);
    for (const int signal : interruptions) sigaddset(&set, signal);
    return set;
}

/// Whoever starts a program by nohup wants it to outlive the terminal.
bool outlivesTerminal(int signal) {
    struct sigaction now {};
    return signal == SIGHUP && ::sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

void handleOnce(void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    for (const int signal : interruptions)
        if (!outlivesTerminal(signal)) ::sigaction(signal, &action, nullptr);
}

}  // namespace

void speakOnInterruption(const ReadingStyle& style) {
    styleOfCommand = &style;
    lineOfInterruption = "drillwave: " + style.said(translatable("interrupted")) + "\n";
}

void holdInterruptions() {
    const sigset_t set = interruptionSet();
    ::sigprocmask(SIG_BLOCK, &set, nullptr);
}

void exitOnInterruption() {
    handleOnce(exitAtOnce);
    const sigset_t set = interruptionSet();
    ::sigprocmask(SIG_UNBLOCK, &set, nullptr);
}

Interruption::Interruption() {
    if (::pipe2(wakeUp, O_CLOEXEC) != 0) throw tooFewFiles(errno);
    const auto watch = [this] {
        char byte = ended;
        while (::read(wakeUp[0], &byte, 1) < 0 && errno == EINTR) {
        }
        if (byte == interrupted) m_source.request_stop();
    };
    // Before the watcher, so that whoever sees its thread may send a signal; until it reads, the pipe keeps
    // the byte.
    handleOnce(onSignal);
    try {
        m_watcher = std::jthread(watch);
    } catch (const std::system_error&) {
        // No thread is left: a signal ends the program at once.
        exitOnInterruption();
    }
}

Interruption::~Interruption() {
    struct sigaction now {};
    ::sigaction(SIGINT, nullptr, &now);
    if (now.sa_handler != SIG_IGN) exitOnInterruption();
    send(ended);
    if (m_watcher.joinable()) m_watcher.join();
    ::close(wakeUp[0]);
    ::close(wakeUp[1]);
}

const ReadingStyle& Interruption::style() const {
    return styleOfCommand ? *styleOfCommand : plainStyle();
}

void Interruption::disable() const {
    for (const int signal : interruptions) std::signal(signal, SIG_IGN);
}

void Interruption::check() const {
    if (m_source.stop_requested())
        throw CommandError(ExitCode::interrupted, translatable("interrupted; no output was left behind"));
}

}  // namespace drillwave
