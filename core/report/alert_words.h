// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of alerts, which the model gives as codes with numbers.
#pragma once

#include <string>

#include "core/model/alerts.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

/// Returns the text of an alert, one or two sentences. `alert` must have the arguments that alertsFor(),
/// resultAlerts() or stressAlerts() give for its code.
Message alertMessage(const Alert& alert, const ReadingStyle& style = plainStyle());
/// Returns the text of an alert in the language of the reader.
std::string alertText(const Alert& alert, const ReadingStyle& style = plainStyle());

}  // namespace drillwave
