#include "app/interruption.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

#include "app/command_error.h"

namespace drillwave {

namespace {

// Requesting a stop takes locks, which a signal handler may not: it writes a byte that a thread is waiting
// for.
int wakeUp[2] = {-1, -1};
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

void handleOnce(int signal) {
    struct sigaction action {};
    action.sa_handler = onSignal;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    ::sigaction(signal, &action, nullptr);
}

}  // namespace

Interruption::Interruption() {
    if (::pipe2(wakeUp, O_CLOEXEC) != 0)
        throw CommandError(ExitCode::internalError, "no pipe left for the signal handler; close some files");
    m_watcher = std::jthread([this] {
        char byte = ended;
        while (::read(wakeUp[0], &byte, 1) < 0 && errno == EINTR) {
        }
        if (byte == interrupted) m_source.request_stop();
    });
    handleOnce(SIGINT);
    handleOnce(SIGTERM);
}

Interruption::~Interruption() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    send(ended);
    m_watcher.join();
    ::close(wakeUp[0]);
    ::close(wakeUp[1]);
}

void Interruption::check() const {
    if (m_source.stop_requested())
        throw CommandError(ExitCode::interrupted, "interrupted; no output was left behind");
}

}  // namespace drillwave
