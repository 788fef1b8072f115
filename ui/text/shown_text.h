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

/// Translates a text under the context `drillwave`, as QObject::tr() does for classes.
QString tr(const char* text);

/// UTF-8 as Qt's own text.
QString fromView(std::string_view text);

/// Prepares a text with names or paths in it for a message or a tooltip: Qt shows all of it and takes nothing
/// as markup; printableLines().
QString withoutMarkup(const QString& text);

/// "f I₀ ± φ" for "f I0 +- phi", as the commands write where a terminal may lack the signs.
QString withSigns(QString text);

/// A pattern of a Message in the language of the window.
std::string translatedPattern(const std::string& pattern);

/// A sentence of the core in the language of the window.
QString translated(const Message& message);
/// Joins the translated sentences.
QString translatedAll(const std::vector<Message>& sentences);

/// Returns the faults of a file or of values in the window's language, a line each.
QString translated(const ScenarioError& error);

/// "t₀" for "t0".
QString shownSymbol(std::string_view symbol);

// The words of the core's tables in the language of the window.

/// Translates a label, meaning or title of a table of the core; a text that is not in the catalogues stays.
/// For the texts in them see tests/support/core_texts.h.
QString coreText(std::string_view text);

/// "half sine" for the name `half_sine` of a value of an enumeration.
QString coreName(std::string_view name);

/// "stiffness"; of a section "length of hammer section 1", of the law of the rock "force of corner 2".
QString parameterLabel(const Parameter& parameter);

/// Names a section as the tables of its scenario do: "length of 2nd rod".
QString parameterLabel(const Parameter& parameter, const Scenario& scenario);

/// Label and symbol, "stiffness k".
QString parameterTitle(const Parameter& parameter);
/// Names a section as above.
QString parameterTitle(const Parameter& parameter, const Scenario& scenario);

/// Returns a sentence of the core with the titles of parameters instead of their keys, as the form has them.
Message withTitles(Message message);

}  // namespace drillwave
