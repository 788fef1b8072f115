// SPDX-License-Identifier: GPL-3.0-or-later
// Report on one solved blow as text.
#pragma once

#include <string>

#include "core/blow/blow.h"
#include "core/text/handy_text.h"

namespace drillwave {

/// Returns a summary of a blow as text, with numbers rounded to six digits. Requires a solved blow.
std::string blowText(const Blow& blow, const ReadingStyle& style = plainStyle());

}  // namespace drillwave
