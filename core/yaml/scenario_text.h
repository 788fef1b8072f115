// SPDX-License-Identifier: GPL-3.0-or-later
// Values of a scenario that a file keeps, and writing such a file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/parameter.h"
#include "core/model/scenario.h"

namespace drillwave {

/// Unit of a saved number.
struct SavedUnit {
    Quantity quantity = Quantity::ratio;
    const Unit* customary = nullptr;
};

/// Line of a scenario file: a number, or a text (title, shape, file of a table, name of a section).
struct SavedValue {
    std::string section;   ///< path of the map it is in: "rod", "hammer.sections.0", "string.2.of.1", …;
                           ///< empty at the top level. Items of lists are counted from 0.
    std::string_view key;  ///< inside the section
    std::optional<SavedUnit> unit;         ///< nothing for a text
    double number = 0;                     ///< SI
    std::string text;                      ///< of a text, as it is
    bool isDefault = false;                ///< an absent key has the same meaning
    bool isUnusual = false;                ///< written to a new file only if it is not the default
    const Parameter* parameter = nullptr;  ///< of the table of parameters, or nullptr
};

/// Returns all values of a file, in its order. The points of an inline table are not among them.
std::vector<SavedValue> savedValues(const Scenario& scenario);

/// Returns the scenario without values that its form and shape do not use, which no file keeps.
Scenario withoutUnusedValues(const Scenario& scenario);

/// Returns the value as it stands after its key, in the default unit or the given one.
std::string valueText(const SavedValue& value, const Unit* unit = nullptr);

/// Returns a text as a YAML scalar, quoted if necessary.
std::string yamlScalar(std::string_view text);

/// Returns the whole file in its default form.
std::string scenarioText(const Scenario& scenario);

/// Paths of the lists of a file, beside "string" and the groups in it.
inline constexpr std::string_view pointsPath = "pulse.points", cornersPath = "bit_rock.corners",
                                  hammerSectionsPath = "hammer.sections";

/// Returns the items of one of these lists as a new file has them, without dashes; an item of several lines
/// has no indentation of its own. Empty where the scenario has no such list.
std::vector<std::string> listItems(const Scenario& scenario, std::string_view list);

/// Returns the values of one path in braces, an item of a list.
std::string sectionItem(const std::vector<SavedValue>& values, std::string_view path);

/// Returns items as a list, one line or more each, behind that many blanks.
std::string listText(const std::vector<std::string>& items, std::size_t indentation);

/// Returns a section of it: "drill:\n  thrust: 8 kN\n".
std::string sectionText(const Scenario& scenario, std::string_view section);

}  // namespace drillwave
