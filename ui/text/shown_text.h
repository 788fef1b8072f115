// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of the core library as a window shows them.
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

// Translation of texts in functions that belong to no QObject.

/// Returns the translation of a text, for functions that belong to no class with QObject::tr(). The catalogue
/// lists such texts in the context `drillwave`.
QString tr(const char* text);

/// Returns UTF-8 text as a QString.
QString fromView(std::string_view text);

/// Returns a text for a message or a tooltip so that Qt does not interpret names or paths in it as markup.
/// Control characters are made visible, see printableLines().
QString withoutMarkup(const QString& text);

/// Returns a text with the signs that terminals may lack: "f I₀ ± φ" for "f I0 +- phi".
QString withSigns(QString text);

/// Returns the translation of the pattern of a Message, which is a sentence with placeholders such as "%1".
std::string translatedPattern(const std::string& pattern);

/// Returns a message of the core library in the language of the window.
QString translated(const Message& message);
/// Returns messages of the core library in the language of the window, as a list.
QStringList translatedEach(const std::vector<Message>& sentences);
/// Returns messages of the core library in the language of the window, joined by blanks.
QString translatedAll(const std::vector<Message>& sentences);

/// Returns the errors of a file or of values in the language of the window, one per line.
QString translated(const ScenarioError& error);

/// Returns a symbol with its index as a subscript: "t₀" for "t0".
QString shownSymbol(std::string_view symbol);

// Texts from the tables of the core library in the language of the window.

/// Returns a label, meaning or title from a table of the core library in the language of the window. Returns
/// it unchanged if there is no translation. The list of translated texts is in tests/support/core_texts.h.
QString coreText(std::string_view text);

/// Returns the translated name of an enumerator: "half sine" for `half_sine`.
QString coreName(std::string_view name);

/// Returns the label of a parameter: "stiffness", "length of hammer section 1", "force of corner 2".
QString parameterLabel(const Parameter& parameter);

/// Returns the label of a parameter. If it belongs to a section, the label contains the name of that section
/// in the scenario: "length of 2nd rod".
QString parameterLabel(const Parameter& parameter, const Scenario& scenario);

/// Returns label and symbol of a parameter, "stiffness k".
QString parameterTitle(const Parameter& parameter);
/// Returns label and symbol of a parameter. For a parameter of a section it returns only the label: "length
/// of 2nd rod".
QString parameterTitle(const Parameter& parameter, const Scenario& scenario);

/// Returns a message in which keys of parameters are replaced by their titles, as in the form.
Message withTitles(Message message);

}  // namespace drillwave
