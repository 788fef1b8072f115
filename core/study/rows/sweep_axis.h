// SPDX-License-Identifier: GPL-3.0-or-later
// Axis of a sweep: a parameter and the values that it takes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/model/parameter.h"
#include "core/model/parameter_text.h"
#include "core/model/preset.h"
#include "core/study/rows/row_column.h"

namespace drillwave {

/// Axis of a sweep: values of a numeric parameter, of a word parameter, or presets of one component. Ranges
/// are stored by their ends and count, not value by value.
struct SweepAxis {
    enum class Kind { linear, logarithmic, list, words, presets };

    KeptParameter parameter = {};  ///< parameter that is varied; null for Kind::words and Kind::presets
    const WordParameter* words = nullptr;  ///< word parameter that is varied; only for Kind::words
    SharedPresetChoice presets = {};       ///< presets that are varied; only for Kind::presets
    const Unit* unit = nullptr;  ///< unit of the column as typed; the SI unit if several units were typed
    Kind kind = Kind::list;
    double start = 0;         ///< first value of a range, in SI units
    double stop = 0;          ///< last value of a range, in SI units
    std::uint64_t count = 0;  ///< number of values, at least 1
    /// Values of Kind::list, in SI units; for Kind::words and Kind::presets, the indices of the words.
    std::vector<double> list;

    /// Returns the heading, kind and unit of the column with the values of the axis. Headings are "beta" or
    /// "rod.length [mm]", for example.
    RowColumn column() const;
    std::string_view key() const;

    /// Returns value number i (from 0) in SI units, or for words and presets the index of the word. The ends
    /// of a range are exactly as typed. Values between them are evenly spaced in `unit`, or have equal
    /// ratios on a logarithmic axis.
    double value(std::uint64_t i) const;
    /// Returns the smallest and the largest value, as the range of a diagram axis with a margin. The range
    /// is widened at both ends by `room` times the difference of the two values (of their logarithms on a
    /// logarithmic axis). A single value is widened on both sides by a twentieth of its size.
    std::pair<double, double> range(double room = 0) const;
    bool isLogarithmic() const { return kind == Kind::logarithmic; }
    /// Sets a value (SI) of the axis in a scenario. Returns why the scenario cannot have it, such as
    /// "rod.bore does not apply here: …"; empty if it was set.
    Message assign(Scenario& scenario, double value) const;
    /// Returns why a scenario does not have `value` although assign() has set it, for example because a
    /// later axis changed it. Empty if it has the value, and for words and presets. Must be called after all
    /// axes were set.
    Message readBackProblem(const Scenario& scenario, double value) const;
    /// Returns the indices of the smallest and the largest value; for words and presets, the indices of all
    /// values.
    std::vector<std::uint64_t> extremes() const;
    bool operator==(const SweepAxis&) const = default;
};

/// Maximum number of values of one axis, and of points of a grid.
inline constexpr std::uint64_t maximumSweepPoints = 1'000'000'000'000;

/// Axis read from text, or the problem why it could not be read.
struct ParsedAxis {
    /// Kind of problem: malformed text, or a value that the parameter cannot take.
    enum class Kind { badText, badValue } kind = Kind::badText;
    SweepAxis axis;
    Message problem;
};

/// Returns an axis along which a continuous curve is computed, read from "KEY=START:STOP" or
/// "KEY=START:STOP:log". Its values are only start and stop. There is a problem if the text or a value is
/// invalid, or if followProblem() refuses the range.
ParsedAxis parseRange(std::string_view text);

/// Returns why a continuous curve cannot be computed along an axis, for example because `stop` is not above
/// `start`. Empty if it can. Requires that both ends are valid values of the parameter.
Message followProblem(const SweepAxis& axis);

/// Returns the message that `stop` of an axis must be above its `start`.
Message mustRise(const SweepAxis& axis);

/// Returns the number of evenly spaced values from `start` to `stop` if the user gives none: `most` (≥ 2).
/// If the parameter takes only whole numbers, it is the largest number up to `most` for which all values are
/// whole. `most` is returned if `stop` − `start` is not a whole number ≥ 1.
std::uint64_t countWithin(const Parameter& parameter, double start, double stop, std::uint64_t most);

/// Returns the axis read from "KEY=START:STOP:COUNT", "KEY=START:STOP:COUNT:log" or "KEY=A,B,C", or a
/// problem. Values have units if the parameter has one ("rod.length=3m:6m:4") and must lie in the allowed
/// range of the parameter. With `assumedCount`, COUNT may be omitted; countWithin() then chooses it, at most
/// `assumedCount`.
ParsedAxis parseAxis(std::string_view text, std::optional<std::uint64_t> assumedCount = {});

}  // namespace drillwave
