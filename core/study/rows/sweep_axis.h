// SPDX-License-Identifier: GPL-3.0-or-later
// One axis of a sweep: a parameter and the values it takes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/parameter.h"
#include "core/model/parameter_text.h"
#include "core/model/preset.h"
#include "core/study/rows/row_column.h"

namespace drillwave {

/// The values of one parameter, or the words of one that is a word, or presets of one part, along an axis.
/// Ranges are not stored value by value.
struct SweepAxis {
    enum class Kind { linear, logarithmic, list, words, presets };

    KeptParameter parameter = {};          ///< none for Kind::words and Kind::presets
    const WordParameter* words = nullptr;  ///< of Kind::words
    SharedPresetChoice presets = {};       ///< of Kind::presets
    const Unit* unit = nullptr;            ///< of the column: as typed, SI where several were typed
    Kind kind = Kind::list;
    double start = 0;          ///< SI
    double stop = 0;           ///< SI
    std::uint64_t count = 0;   ///< number of values, at least 1
    std::vector<double> list;  ///< Kind::list, SI; Kind::words and Kind::presets, the numbers of the words

    /// Its column of numbers, headed "beta" or "rod.length [mm]".
    RowColumn column() const;
    std::string_view key() const;

    /// The i-th value in SI, the ends exactly as given, even steps in `unit`; a word as its number.
    double value(std::uint64_t i) const;
    /// Sets one of its values. Returns why the scenario cannot have it, "rod.bore has no meaning here: …";
    /// empty when it has.
    Message assign(Scenario& scenario, double value) const;
    /// Why a scenario in which all axes have been set does not hold that value; empty when it does.
    Message readBackProblem(const Scenario& scenario, double value) const;
    /// Returns the indices of extreme values: two; for words and presets, all.
    std::vector<std::uint64_t> extremes() const;
    bool operator==(const SweepAxis&) const = default;
};

/// Most values that one axis may have, and most points of a grid.
inline constexpr std::uint64_t maximumSweepPoints = 1'000'000'000'000;

/// Axis read from text, or why not.
struct ParsedAxis {
    /// Kind of problem: in the words, or a value that the parameter cannot take.
    enum class Kind { badText, badValue } kind = Kind::badText;
    SweepAxis axis;
    Message problem;
};

/// Reads "KEY=START:STOP" or "KEY=START:STOP:log", a range to be followed from START up to STOP: an axis of
/// two values. Refuses ranges so narrow that their values cannot be distinguished, besides the usual errors.
ParsedAxis parseRange(std::string_view text);

/// Returns why no curve can follow the axis from `start` up to `stop`, however it was made: the reasons of
/// parseRange() for an axis whose ends are values of its parameter. Empty if one can.
Message followProblem(const SweepAxis& axis);

/// Returns the message that the range of an axis must end above its beginning.
Message mustRise(const SweepAxis& axis);

/// Returns how many even steps from `start` to `stop` give values of a parameter if `most` (≥ 2) are wanted:
/// that many, but for whole numbers only as many as hit whole numbers.
std::uint64_t countWithin(const Parameter& parameter, double start, double stop, std::uint64_t most);

/// Reads "KEY=START:STOP:COUNT", "KEY=START:STOP:COUNT:log" or "KEY=A,B,C"; units on the values where the
/// parameter has one ("rod.length=3m:6m:4"). Every value is inside the hard range of the parameter.
/// Where `assumedCount` is given, the COUNT of a range may be left out: it is countWithin() that.
ParsedAxis parseAxis(std::string_view text, std::optional<std::uint64_t> assumedCount = {});

}  // namespace drillwave
