// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of the core as a window shows them.
#pragma once

#include <QString>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/parameter.h"
#include "core/model/section_field.h"
#include "core/text/message.h"

namespace drillwave {

class ScenarioError;

// Words for people in functions that belong to no QObject.

/// In the language of the program, under the context `drillwave`: what QObject::tr() is for classes.
QString tr(const char* text);

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
/// Sentences of the core in the language of the window, one by one or joined by blanks.
QStringList translatedEach(const std::vector<Message>& sentences);
QString translatedAll(const std::vector<Message>& sentences);

/// Returns the faults of a file or of values in the language of the window, one per line.
QString translated(const ScenarioError& error);

/// "t₀" for "t0".
QString shownSymbol(std::string_view symbol);

// The words of the core's tables in the language of the window.

/// A label, meaning or title of a table of the core; what the catalogues do not have stays as it is. Which
/// texts they have: tests/support/core_texts.h.
QString coreText(std::string_view text);

/// "half sine" for the name `half_sine` of a value of an enumeration.
QString coreName(std::string_view name);

/// "stiffness"; of a section "length of hammer section 1", of the law of the rock "force of corner 2".
QString parameterLabel(const Parameter& parameter);

/// The same with a section as the tables of its scenario call it: "length of 2nd rod".
QString parameterLabel(const Parameter& parameter, const Scenario& scenario);

/// Label and symbol, "stiffness k".
QString parameterTitle(const Parameter& parameter);
/// The same with a section as above.
QString parameterTitle(const Parameter& parameter, const Scenario& scenario);

/// Returns a sentence of the core about parameters with titles instead of keys, as in the form.
Message withTitles(Message message);

}  // namespace drillwave
