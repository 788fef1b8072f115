// SPDX-License-Identifier: GPL-3.0-or-later
// Values of a scenario as its file stores them, and the text of such a file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/parameter.h"
#include "core/model/scenario.h"

namespace drillwave {

/// Quantity and default unit of a number in a scenario file.
struct SavedUnit {
    Quantity quantity = Quantity::ratio;
    const Unit* customary = nullptr;
};

/// Value in a scenario file: a number, or a text (title, shape, table file, name of a section).
struct SavedValue {
    /// Path of the YAML map that contains the value: "rod", "hammer.sections.0", "string.2.of.1"; empty at
    /// the top level. Items of lists are counted from 0.
    std::string section;
    std::string_view key;           ///< key of the value within its map, "length"
    std::optional<SavedUnit> unit;  ///< quantity and default unit of a number; nullopt for a text
    double number = 0;              ///< value in SI, if it is a number
    std::string text;               ///< value, if it is a text
    bool isDefault = false;         ///< whether an absent key has the same meaning
    bool isUnusual = false;         ///< whether a new file omits the value if it is the default
    /// Parameter that the value belongs to; nullptr if it is not in the table of parameters.
    const Parameter* parameter = nullptr;
};

/// Returns all values of a scenario file, in the order of the file, except the points of a force table within
/// it.
std::vector<SavedValue> savedValues(const Scenario& scenario);

/// Returns the scenario with defaults for all values without effect. These are values that the form of the
/// scenario (such as a drill string) or the shape of the hammer force does not use. Scenario files do not
/// store them.
Scenario withoutUnusedValues(const Scenario& scenario);

/// Returns a value as it is written after its key, "3660 mm", in its default unit or the given one.
std::string valueText(const SavedValue& value, const Unit* unit = nullptr);

/// Returns a text as a YAML scalar, quoted if necessary.
std::string yamlScalar(std::string_view text);

/// Returns the text of a new scenario file.
std::string scenarioText(const Scenario& scenario);

/// Paths of three lists in a scenario file, which listItems() accepts: points of a force table, corners of
/// the loading curve, and sections of the hammer. The path of the sections of the string is "string".
inline constexpr std::string_view pointsPath = "pulse.points", cornersPath = "bit_rock.corners",
                                  hammerSectionsPath = "hammer.sections";

/// Returns the items of a list as YAML for a new scenario file, such as those of "bit_rock.corners". They
/// have no dashes and no indentation, even if an item has several lines. Empty if the scenario has no such
/// list.
std::vector<std::string> listItems(const Scenario& scenario, std::string_view list);

/// Returns one list item of a scenario file as a YAML map in braces, "{length: 3660 mm, …}". It contains
/// those of `values` whose `section` is `path`, such as "hammer.sections.0".
std::string sectionItem(const std::vector<SavedValue>& values, std::string_view path);

/// Returns items as lines of a YAML list, "- …". The dashes are indented by this number of blanks; an item
/// may have several lines.
std::string listText(const std::vector<std::string>& items, std::size_t indentation);

/// Returns one section of a new scenario file as text, such as "drill:\n  thrust: 8 kN\n".
std::string sectionText(const Scenario& scenario, std::string_view section);

}  // namespace drillwave
