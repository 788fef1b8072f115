// SPDX-License-Identifier: GPL-3.0-or-later
// A row of the one table of parameters: scenario files, --set, sweep axes, CSV headers, form rows, tooltips
// and messages all take keys, symbols, units, ranges and meanings from here (files §2).
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

// A parameter to keep: of axes, families, table columns and edits. References that are only used at once take
// a const Parameter&.

/// A row of the table of parameters, the repeat of a string, or a number of a section, which lives as long as
/// it is kept; or none. A value: copies are cheap, and two with the same key are equal.
class KeptParameter {
  public:
    KeptParameter() = default;
    KeptParameter(std::nullptr_t) {}
    /// Keeps the same parameter.
    KeptParameter(const Parameter& parameter);
    /// Keeps one that nobody else keeps.
    explicit KeptParameter(std::shared_ptr<const Parameter> parameter);

    explicit operator bool() const { return m_parameter != nullptr; }
    /// Requires that there is one. Except for rows of the table it lives only as long as it is kept.
    const Parameter& operator*() const;
    const Parameter* operator->() const { return &**this; }

    friend bool operator==(const KeptParameter& one, const KeptParameter& other);

  private:
    std::shared_ptr<const Parameter> m_parameter;  // without an owner where it lives as long as the program
};

/// A range of a parameter in SI. An open end is excluded.
struct Range {
    double low;
    double high;
    bool lowOpen = false;
    const char* whyNotMore = "";  ///< why there is an upper end, for messages; may be empty
    bool highOpen = false;
    bool contains(double value) const;
    /// "(0, 1]", of a range with an upper end; in a unit.
    std::string ends() const;
    std::string ends(const Unit& unit) const;
    /// Returns why a value (SI, finite or not) is outside: "must be in (0, 1]", in the given unit, with its
    /// name after it if it has one; empty if it is inside.
    Message problem(double value, const Unit& unit) const;
};

enum class SliderScale { linear, logarithmic };

/// A function of a scenario, for a parameter of a section also of which one (section_field.h).
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

/// Scenarios in which a parameter has a meaning.
enum class Scope {
    all,
    withUnits,      ///< in physical quantities
    withoutUnits,   ///< dimensionless
    manyBlows,      ///< with units; a single blow does not depend on it
    string,         ///< string of sections
    hammer,         ///< that, struck by a hammer that is followed
    section,        ///< that, with such sections in it (section_parameter.h)
    uniformRod,     ///< in either form
    dimensional,    ///< a uniform rod in physical quantities
    withoutArea,    ///< dimensional, the rod given by its diameters
    givenPulse,     ///< with units, for a force whose duration and impulse follow from no piston or table
    trapezoid,      ///< of a force of that shape
    pistonInSi,     ///< with units, of a force of that shape
    pistonByRatio,  ///< dimensionless, with that shape
};

/// Whether a scenario file may leave a parameter out.
enum class Presence {
    required,
    either,    ///< exactly one of it and its rival is required
    assumed,   ///< where it is missing, it has the value of a new scenario
    unusual,   ///< as `assumed`, but written to a new file only if the value is another one
    optional,  ///< need not have a value, or follows from its rival
};

/// Rules on parameters that may be left out or exclude each other.
struct ParameterRules {
    Presence presence = Presence::required;
    /// Key of the parameter that setting this one overrides, and vice versa; only one of a pair has it.
    std::string_view rival = {};
    std::string_view shortLabel = {};  ///< label in its own section of a form, where that is another one
    /// Back to "not given"; nullptr where there is always a value.
    ParameterFunction<void, Scenario> clear = nullptr;
    bool wholeNumber = false;         ///< has no values between
    std::optional<RockLaw> law = {};  ///< only a rock with that law has it, and must
};

/// A number of a scenario: how it is called, which values it may have, how to read and set it.
struct Parameter {
    std::string_view key;      ///< path in files and on the command line, e.g. "rod.length", "beta"
    std::string_view label;    ///< words for a form row, e.g. "length"
    std::string_view symbol;   ///< symbol of the paper, may be empty
    std::string_view meaning;  ///< one line, for tooltips and help
    Quantity quantity;
    std::string_view unit;  ///< default unit for display and file output, e.g. "mm"
    Range hard;             ///< outside: the scenario is invalid
    Range plausible;        ///< outside: an alert; also the range of a slider
    SliderScale slider;
    Scope scope;
    /// Returns the value in SI, or nullopt if an optional parameter is not given, or if the sections that it
    /// refers to differ in it. Requires applies().
    ParameterFunction<std::optional<double>, const Scenario> value;
    /// Sets the value in SI (no range check). Groups of a scenario with units move the physical parameter
    /// (beta the stiffness, tau the rod length, delta the gap). Requires applies().
    ParameterFunction<void, Scenario, double> assign;
    ParameterRules rules = {};
    const SectionAddress* address = nullptr;  ///< of a number of a section, else nullptr

    /// Returns whether the parameter has a meaning in this scenario.
    bool applies(const Scenario& scenario) const;
    /// Returns the unit in which values are shown.
    const Unit& displayUnit() const;
    bool isGroup() const;                  ///< one of the four dimensionless groups
    std::string_view section() const;      ///< "rod", "pulse", "bit_rock", "drill", …, "groups", or none
    std::string_view fileSection() const;  ///< section(), but "dimensionless" for the groups
    std::string_view localKey() const;     ///< the key inside its section of a file
};

/// The keys of a scenario that are set by a word and not by a number.
inline constexpr std::string_view pulseShapeKey = "pulse.shape";
inline constexpr std::string_view rockLawKey = "bit_rock.law";
inline constexpr std::string_view rockIndexingKey = "drill.indexing";
inline constexpr std::string_view restrikeKey = "hammer.restrike";

/// Returns the parameter of that key: of the table, of a corner of the law
/// (law_parameter.h), "string.repeat", or a number of a section ("string.adapter.length",
/// "hammer.1.diameter", see section_field.h), even if there is no such section; otherwise
/// none. Thread-safe.
KeptParameter findParameter(std::string_view key);

/// Returns whether the user gave the parameter, so that it does not follow from others (the groups of a
/// dimensional scenario; the impulse if the mean force was given).
bool isGiven(const Parameter& parameter, const Scenario& scenario);

/// Why `value` (SI, finite or not) is outside the hard range: "must be in (0, 1]"; empty when it is inside.
Message rangeProblem(const Parameter& parameter, double value);
/// Returns the unit for ends of a range in messages: SI, and for shares their usual unit, %.
const Unit& unitOfRange(Quantity quantity, const Unit& customary);

/// Returns why the scenario does not have the value `wanted` (SI) after assigning it: it keeps the physical
/// value of a group, or the impulse of a force, which may be at the end of double precision. "cannot be kept
/// …"; empty if it reads back to 1e-12. Requires applies().
Message readBackProblem(const Parameter& parameter, const Scenario& scenario, double wanted);

// The one table of parameters: a row each, to which a new one is added.

/// Returns all numeric parameters except those of sections, physical ones first, the groups last, in the
/// order of scenario files.
std::span<const Parameter> parameters();

}  // namespace drillwave
