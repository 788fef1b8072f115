// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of the core as a window shows them.
#pragma once

#include <QString>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/message.h"

namespace drillwave {

class ScenarioError;

/// UTF-8 as Qt's own text.
QString fromView(std::string_view text);

/// A text with names or paths in it for a message or a tooltip: Qt shows it as it is and takes nothing of it
/// for markup; printableLines().
QString withoutMarkup(const QString& text);

/// "f I₀ ± φ" for "f I0 +- phi", as the commands write where a terminal may lack the signs.
QString withSigns(QString text);

/// A pattern of a Message in the language of the window.
std::string translatedPattern(const std::string& pattern);

/// A sentence of the core in the language of the window.
QString translated(const Message& message);
/// One sentence behind the other.
QString translatedAll(const std::vector<Message>& sentences);

/// What is wrong with a file or with values, a line each, likewise.
QString translated(const ScenarioError& error);

/// "t₀" for "t0".
QString shownSymbol(std::string_view symbol);

}  // namespace drillwave
