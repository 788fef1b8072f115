// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl-C as a stop token.
#pragma once

#include <stop_token>
#include <thread>

#include "core/text/handy_text.h"

namespace drillwave {

/// Lets the first SIGINT, SIGTERM or, unless it is ignored (nohup), SIGHUP end the program with
/// ExitCode::interrupted, in one line: there are no files yet that could be left over.
void exitOnInterruption();

/// Sets the style of that line, for as long as the program runs.
void speakOnInterruption(const ReadingStyle& style);

/// Holds these signals until exitOnInterruption(), also in the program that replaces this one (exec).
void holdInterruptions();

/// Keeps them waiting as long as one lives, and then ends the program where one has come.
class HeldInterruptions {
  public:
    HeldInterruptions() { holdInterruptions(); }
    ~HeldInterruptions() { exitOnInterruption(); }
    HeldInterruptions(const HeldInterruptions&) = delete;
    HeldInterruptions& operator=(const HeldInterruptions&) = delete;
};

/// While an object exists, the first of these signals requests a stop instead of ending the program; a second
/// signal ends the program at once. If no thread can be started, the first signal does. One object at a time.
class Interruption {
  public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    std::stop_token token() const { return m_source.get_token(); }
    /// Throws CommandError (interrupted) if a stop was requested.
    void check() const;
    /// Ignores signals until the program ends, because all output is written.
    void disable() const;
    /// The style of speakOnInterruption().
    const ReadingStyle& style() const;

  private:
    std::stop_source m_source;
    std::jthread m_watcher;
};

}  // namespace drillwave
