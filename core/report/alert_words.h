// SPDX-License-Identifier: GPL-3.0-or-later
// Remarks as sentences: what the model says with codes and numbers, in words.
#pragma once

#include <string>

#include "core/model/alerts.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

/// Returns the one or two sentences of an alert. `alert` must have the arguments that alertsFor(),
/// resultAlerts() or stressAlerts() give with its code.
Message alertMessage(const Alert& alert, const ReadingStyle& style = plainStyle());
/// The same in the language of the reader.
std::string alertText(const Alert& alert, const ReadingStyle& style = plainStyle());

}  // namespace drillwave
