// SPDX-License-Identifier: GPL-3.0-or-later
// Conversion of Ctrl-C and similar signals into a stop token.
#pragma once

#include <stop_token>
#include <thread>

#include "core/text/handy_text.h"

namespace drillwave {

/// Makes the first SIGINT, SIGTERM or SIGHUP end the program with one line and ExitCode::interrupted. A
/// SIGHUP that is ignored (nohup) stays ignored. Use it while no output files exist that could be left
/// incomplete.
void exitOnInterruption();

/// Sets the language of the line that is printed on an interruption. `style` must exist until the program
/// ends.
void speakOnInterruption(const ReadingStyle& style);

/// Blocks SIGINT, SIGTERM and SIGHUP until exitOnInterruption() is called, also in programs started by exec.
/// Signals that arrive meanwhile are delivered after that.
void holdInterruptions();

/// Object that blocks SIGINT, SIGTERM and SIGHUP during its lifetime. A signal that arrives during this time
/// ends the program when the object is destroyed.
class HeldInterruptions {
  public:
    HeldInterruptions() { holdInterruptions(); }
    ~HeldInterruptions() { exitOnInterruption(); }
    HeldInterruptions(const HeldInterruptions&) = delete;
    HeldInterruptions& operator=(const HeldInterruptions&) = delete;
};

/// Object that handles SIGINT, SIGTERM and SIGHUP during its lifetime. The first signal requests a stop
/// instead of ending the program; a second one ends the program at once. If no thread can be started, the
/// first signal ends it. Only one object may exist at a time.
class Interruption {
  public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    std::stop_token token() const { return m_source.get_token(); }
    /// Throws CommandError (interrupted) if a signal has requested a stop.
    void check() const;
    /// Makes the program ignore signals from now on, because all output is written.
    void disable() const;
    /// Returns the style (language and number format) of messages, as set by speakOnInterruption(). Without
    /// it, returns the plain English style.
    const ReadingStyle& style() const;

  private:
    std::stop_source m_source;
    std::jthread m_watcher;
};

}  // namespace drillwave
