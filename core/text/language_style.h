// SPDX-License-Identifier: GPL-3.0-or-later
// The style of the commands in each of the languages.
#pragma once

#include "core/text/handy_text.h"
#include "core/text/languages.h"

namespace drillwave {

/// Sentences from the catalogue of the language, numbers with its decimal comma, units in SI; in English it
/// is plainStyle(). Not for several threads.
const ReadingStyle& styleOf(const Language& language);

}  // namespace drillwave
