// SPDX-License-Identifier: GPL-3.0-or-later
// Row of the common table of parameters. Scenario files, --set, sweeps, CSV headers, forms, tooltips and
// messages take keys, symbols, units, ranges and meanings from it (files §2).
#pragma once

#include <concepts>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/model/scenario.h"
#include "core/text/units.h"

namespace drillwave {

struct Parameter;
struct SectionAddress;

// Parameters that are stored, as in axes of sweeps, columns of tables and edits. For immediate use a const
// Parameter& is sufficient.

/// Reference to a parameter, or none, for storage in axes of studies and columns of tables. It may refer to a
/// row of the table of parameters, to the repeat of a drill string, or to a number of a section. Parameters
/// of sections are made when needed; the reference keeps them alive. Copies are cheap; two references to
/// parameters with the same key are equal.
class KeptParameter {
  public:
    KeptParameter() = default;
    KeptParameter(std::nullptr_t) {}
    /// Refers to an existing parameter, and keeps it alive if it belongs to a section.
    KeptParameter(const Parameter& parameter);
    /// Takes shared ownership of a newly made parameter, one that is not in the table of parameters.
    explicit KeptParameter(std::shared_ptr<const Parameter> parameter);

    explicit operator bool() const { return m_parameter != nullptr; }
    /// Returns the parameter. Requires that there is one. A reference to a parameter of a section is valid
    /// only while this object or a copy of it exists.
    const Parameter& operator*() const;
    const Parameter* operator->() const { return &**this; }

    friend bool operator==(const KeptParameter& one, const KeptParameter& other);

  private:
    // does not own rows of the table, which live as long as the program
    std::shared_ptr<const Parameter> m_parameter;
};

/// Allowed or typical range of a parameter in SI. An end that is "open" does not itself belong to the range.
struct Range {
    double low;
    double high;
    bool lowOpen = false;
    const char* whyNotMore = "";  ///< reason for the upper end, for messages; may be empty
    bool highOpen = false;
    bool contains(double value) const;
    /// Returns the range as text such as "(0, 1]", in SI or in the given unit. An infinite upper limit is not
    /// allowed.
    std::string ends() const;
    std::string ends(const Unit& unit) const;
    /// Returns why a value (SI, may be infinite or NaN) is outside the range: "must be in (0, 1]". The
    /// message gives the range in `unit`, with its name. Empty if the value is inside.
    Message problem(double value, const Unit& unit) const;
};

enum class SliderScale { linear, logarithmic };

/// Function that reads or changes one parameter in a scenario. It is a plain function, or for a parameter of
/// a section one that also takes the address of the section (section_field.h).
template <class Result, class Scene, class... Values>
class ParameterFunction {
  public:
    using Plain = Result (*)(Scene&, Values...);
    using OfSection = Result (*)(const SectionAddress&, Scene&, Values...);

    constexpr ParameterFunction(std::nullptr_t) {}
    template <std::convertible_to<Plain> Function>
    constexpr ParameterFunction(Function function) : m_plain(function) {}
    ParameterFunction(OfSection function, const SectionAddress& address)
        : m_ofSection(function), m_address(&address) {}

    Result operator()(Scene& scenario, Values... values) const {
        return m_address ? m_ofSection(*m_address, scenario, values...) : m_plain(scenario, values...);
    }
    constexpr explicit operator bool() const { return m_plain || m_address; }

  private:
    Plain m_plain = nullptr;
    OfSection m_ofSection = nullptr;
    const SectionAddress* m_address = nullptr;
};

/// Scenarios to which a parameter applies.
enum class Scope {
    all,
    withUnits,     ///< scenarios in physical quantities
    withoutUnits,  ///< dimensionless scenarios
    manyBlows,     ///< scenarios with units; used only to simulate many blows, not for a single blow
    string,        ///< drill strings of sections
    hammer,        ///< drill strings struck by a hammer of sections, whose motion is simulated
    section,       ///< drill strings that have the section of this parameter (section_parameter.h)
    uniformRod,    ///< uniform rods, with units or dimensionless
    dimensional,   ///< uniform rods in physical quantities
    /// Uniform rods in physical quantities, given by their diameters instead of their area.
    withoutArea,
    /// Scenarios with units whose hammer force is given by duration and impulse, not by a piston or table.
    givenPulse,
    trapezoid,      ///< scenarios with a hammer force of the shape `trapezoid`
    pistonInSi,     ///< scenarios with units and a hammer force of the shape `piston`
    pistonByRatio,  ///< dimensionless scenarios with a hammer force of the shape `piston`
};

/// Rule on whether a scenario file must give a parameter, and what applies if it does not.
enum class Presence {
    required,
    either,    ///< exactly one of the parameter and its rival (`rules.rival`) is required
    assumed,   ///< a file may omit the parameter; then it has its default value
    unusual,   ///< a file may omit the parameter, and new files do so if it has its default value
    optional,  ///< a file may omit the parameter; then it has no value, or follows from its rival
};

/// Rules for a parameter that may be missing, or that excludes another one.
struct ParameterRules {
    Presence presence = Presence::required;
    /// Key of the parameter that excludes this one: setting either of them removes the other. Only one
    /// parameter of such a pair has this entry.
    std::string_view rival = {};
    /// Name in a form under a heading that makes the full `label` unnecessary: "length" instead of "hammer
    /// length". Empty if the form shows `label`.
    std::string_view shortLabel = {};
    /// Function that makes the parameter "not given"; nullptr if the parameter always has a value.
    ParameterFunction<void, Scenario> clear = nullptr;
    bool wholeNumber = false;  ///< whether only whole numbers are allowed
    /// Form of the loading curve of the rock that requires this parameter; other forms do not have it. It is
    /// nullopt if the parameter does not depend on the form.
    std::optional<RockLaw> law = {};
};

/// Numeric parameter of a scenario: its names, unit and ranges, and functions to read and set it.
struct Parameter {
    std::string_view key;      ///< key in files and on the command line, e.g. "rod.length", "beta"
    std::string_view label;    ///< name in forms and messages, e.g. "length"
    std::string_view symbol;   ///< symbol in the paper, e.g. "L"; may be empty
    std::string_view meaning;  ///< explanation in one line, for tooltips and help
    Quantity quantity;
    std::string_view unit;  ///< default unit for display and files, e.g. "mm"
    Range hard;             ///< allowed range; a value outside is an error
    Range plausible;        ///< typical range; a value outside raises a warning; also the range of a slider
    SliderScale slider;
    Scope scope;
    /// Function that returns the value in SI. It returns nullopt if an optional parameter is not given, or if
    /// several sections of one name have different values. Requires applies().
    ParameterFunction<std::optional<double>, const Scenario> value;
    /// Function that sets the value in SI without checking its range. In a scenario with units, setting a
    /// group changes a physical parameter: β the stiffness, τ the rod length, δ the gap. Requires applies().
    ParameterFunction<void, Scenario, double> assign;
    ParameterRules rules = {};
    /// Address of the section that the parameter belongs to; nullptr if it does not belong to a section.
    const SectionAddress* address = nullptr;

    /// Returns whether this scenario has the parameter, so that it can be read and set.
    bool applies(const Scenario& scenario) const;
    /// Returns the unit in which the program shows values of the parameter.
    const Unit& displayUnit() const;
    /// Returns whether the parameter is one of the four dimensionless groups β, γ, τ, δ.
    bool isGroup() const;
    /// Returns the part of the key before the dot: "rod", "pulse", "bit_rock"; "groups" for a dimensionless
    /// group. Empty if the key has no dot.
    std::string_view section() const;
    /// Returns the section of a scenario file that has the parameter: "rod", or "dimensionless" for a
    /// dimensionless group.
    std::string_view fileSection() const;
    /// Returns the key without its section, as in a file: "length" for "rod.length".
    std::string_view localKey() const;
};

/// Keys of a scenario that are set by a word, not by a number.
inline constexpr std::string_view pulseShapeKey = "pulse.shape";
inline constexpr std::string_view rockLawKey = "bit_rock.law";
inline constexpr std::string_view rockIndexingKey = "drill.indexing";
inline constexpr std::string_view restrikeKey = "hammer.restrike";

/// Returns the parameter with this key, or none. The key may be in the table of parameters, belong to a
/// corner of the loading curve (law_parameter.h), or be "string.repeat". It may also be a number of a section
/// (section_field.h), such as "string.adapter.length" or "hammer.1.diameter"; the section need not exist.
/// Thread-safe.
KeptParameter findParameter(std::string_view key);

/// Returns whether the scenario gives this parameter or leaves it out as optional. Returns false if it does
/// not apply or is computed from others, as a group of a scenario with units. The impulse is computed if the
/// mean force was entered.
bool isGiven(const Parameter& parameter, const Scenario& scenario);

/// Returns why `value` (SI, may be infinite or NaN) is outside the allowed range: "must be in (0, 1]"; empty
/// if it is inside.
Message rangeProblem(const Parameter& parameter, double value);
/// Returns the unit in which error messages give the allowed range of a quantity. It is the SI unit; for a
/// share it is `customary`, usually %.
const Unit& unitOfRange(Quantity quantity, const Unit& customary);

/// Returns why a parameter does not have the value `wanted` (SI) just after it was set: "cannot be stored:
/// …". Reason: groups and mean forces are stored as other quantities, which may be at the limit of double
/// precision. Empty if the values agree to 1e-12, and for parameters of sections. Requires applies().
Message readBackProblem(const Parameter& parameter, const Scenario& scenario, double wanted);

// Common table of all parameters. A new parameter is one more row.

/// Returns the table of numeric parameters, in the order of scenario files: physical ones first, the
/// dimensionless groups last. Parameters of sections and of corners of the loading curve are not in this
/// table.
std::span<const Parameter> parameters();

}  // namespace drillwave
