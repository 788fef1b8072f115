// SPDX-License-Identifier: GPL-3.0-or-later
// The language that `--language` asks for.
#pragma once

#include <string>

#include "core/text/languages.h"

namespace drillwave {

/// The one of that code; an empty one is a missing word. Throws CommandError (usage) where there is none.
const Language& languageOf(const std::string& code);

}  // namespace drillwave
