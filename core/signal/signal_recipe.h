// SPDX-License-Identifier: GPL-3.0-or-later
// Steps from recorded samples to a force over time, used as a hammer force or as a curve for comparison.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/model/scenario.h"
#include "core/signal/samples.h"

namespace drillwave {

// Selection of samples of a curve, so that straight lines between them stay close to all samples.

/// Returns the ascending indices of at most `most` ≥ 2 samples, including the first and the last. Straight
/// lines between them approximate all samples, with a largest deviation as small as possible. This deviation
/// is found by bisection to 0.5 %; for each trial value every line is made as long as possible. Requires
/// increasing times. A stop request ends the search early.
std::vector<std::size_t> thinnedCurve(std::span<const double> time, std::span<const double> value,
                                      std::size_t most, const std::stop_token& stop = {});

/// Use of the force. For a hammer force (`blow`), time starts at 0 and the force has only compression; a
/// `curve` for comparison keeps its times. If points of a blow are left out, its forces are scaled to keep
/// the impulse. They are not scaled if this would move them by more than twice the deviation.
enum class SignalUse { blow, curve };

/// Choice of the zero line: the value of the signal without load, which is subtracted from all samples.
enum class ZeroLine {
    asRecorded,      ///< zero line 0: samples are used as recorded
    ofFirstSamples,  ///< zero line is the mean of the first samples, over the time `zeroSpan`
    chosen,          ///< zero line is the given `zeroValue`
};

enum class Negatives { kept, clipped };
enum class Scaling { none, byFactor, toImpulse };

/// Steps from samples to a force over time. They are performed in the order of the members.
struct SignalRecipe {
    SignalUse use = SignalUse::curve;
    ZeroLine zeroLine = ZeroLine::asRecorded;
    /// Time from the start of the record over which the samples are averaged to find the zero line [s].
    double zeroSpan = 0;
    double zeroValue = 0;  ///< given zero line, in the unit of the table
    /// Force that corresponds to the number 1 in the table [N]; negative if the table has the opposite sign.
    double forcePerNumber = 1;
    std::optional<double> from = {};  ///< time of the table [s] before which samples are left out
    std::optional<double> to = {};    ///< time of the table [s] after which samples are left out
    Negatives negatives = Negatives::kept;
    Scaling scaling = Scaling::none;
    double factor = 1;          ///< factor of the forces for Scaling::byFactor
    double impulse = 0;         ///< impulse to which the forces are scaled for Scaling::toImpulse [N s]
    std::size_t points = 1000;  ///< largest number of points of the result, ≥ 2
    bool operator==(const SignalRecipe&) const = default;
};

/// Force over time that shapedSignal() makes from samples, with data on the changes, such as the number of
/// negative samples set to zero.
struct ShapedSignal {
    TablePoints points;         ///< time [s] and force [N]; those of a blow are rounded to nine digits
    double start = 0;           ///< time of the table at which the points begin [s]
    std::size_t samples = 0;    ///< number of samples between `from` and `to`
    double zero = 0;            ///< zero line that was subtracted, in the unit of the table
    std::size_t clipped = 0;    ///< number of negative samples that were set to zero
    double clippedImpulse = 0;  ///< impulse that clipping added [N s], ≥ 0
    double impulse = 0;         ///< impulse of the force given by the points [N s]
    double impulseChange = 0;   ///< impulse of the points minus that of all samples [N s]
    double peak = 0;      ///< force with the largest absolute value among all samples used, with its sign [N]
    double peakTime = 0;  ///< time in the table at which the largest force occurs [s]
    double deviation = 0;  ///< largest distance of a sample from the lines between the points [N]
    std::string problem;   ///< reason why there is no force; then there are no points
};

/// Returns the force over time that results when the steps of `recipe` are applied to the samples. Requires
/// samples without a problem. Impulses are integrals along straight lines between samples.
ShapedSignal shapedSignal(const Samples& samples, const SignalRecipe& recipe,
                          const std::stop_token& stop = {});

/// Returns the zero line, the value without load that is subtracted from all samples, in the unit of the
/// table.
double zeroOf(const Samples& samples, const SignalRecipe& recipe);

/// Start and end of the part of a record around its largest absolute value.
struct RecordSpan {
    double from = 0;  ///< time of the record at the start of this part [s]
    double to = 0;    ///< time of the record at the end of this part [s]
};
/// Returns the part of the record around the sample with the largest distance from the zero line. On both
/// sides it extends to the sample at which the signal falls to 2 % of this distance or changes sign. Returns
/// nullopt if all samples equal the zero line.
std::optional<RecordSpan> spanAroundPeak(const Samples& samples, const SignalRecipe& recipe);

/// Returns the sign, +1 or −1, of the sample with the largest absolute value after subtraction of the zero
/// line.
double signOfPeak(const Samples& samples, const SignalRecipe& recipe);

}  // namespace drillwave
