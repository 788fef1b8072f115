// SPDX-License-Identifier: GPL-3.0-or-later
// Recipe from recorded samples to a force over time, for a blow of the hammer or a curve to compare with.
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

// Some of the samples of a curve, so chosen that the straight lines between them stay close to all of it.

/// At most `most` (≥ 2) of the samples, the first and the last among them, such that the lines between them
/// are, to a fraction of a percent, as close to all samples as this search can have them: for a deviation it
/// goes along the samples once, each line as long as it may be, and the deviation is bisected. Times
/// increase. The indices in order; all where there are no more than `most`. Ends early when it is stopped.
std::vector<std::size_t> thinnedCurve(std::span<const double> time, std::span<const double> value,
                                      std::size_t most, const std::stop_token& stop = {});

/// A blow begins at time 0, pushes only, and keeps its impulse when it is thinned, unless its forces would
/// have to be moved by more than twice the deviation for it; a curve keeps its times.
enum class SignalUse { blow, curve };

/// Value subtracted from all samples.
enum class ZeroLine {
    asRecorded,      ///< nothing
    ofFirstSamples,  ///< their mean over the first `zeroSpan`
    chosen,          ///< `zeroValue`
};

enum class Negatives { kept, clipped };
enum class Scaling { none, byFactor, toImpulse };

/// The steps in the order of their members.
struct SignalRecipe {
    SignalUse use = SignalUse::curve;
    ZeroLine zeroLine = ZeroLine::asRecorded;
    double zeroSpan = 0;              ///< of the record, from its beginning [s]
    double zeroValue = 0;             ///< as in the table
    double forcePerNumber = 1;        ///< N; negative where the table has the other sign
    std::optional<double> from = {};  ///< [s] as in the table: earlier samples are left out
    std::optional<double> to = {};    ///< [s] as in the table: later samples are left out
    Negatives negatives = Negatives::kept;
    Scaling scaling = Scaling::none;
    double factor = 1;          ///< of Scaling::byFactor
    double impulse = 0;         ///< of Scaling::toImpulse [N s]
    std::size_t points = 1000;  ///< that are kept at most, ≥ 2
    bool operator==(const SignalRecipe&) const = default;
};

/// Force over time, and the changes made to get it.
struct ShapedSignal {
    TablePoints points;         ///< time [s], force [N]; of a blow without rounding noise in their digits
    double start = 0;           ///< time of the table at which the points begin [s]
    std::size_t samples = 0;    ///< between `from` and `to`
    double zero = 0;            ///< what was taken off, as in the table
    std::size_t clipped = 0;    ///< samples that were negative
    double clippedImpulse = 0;  ///< what clipping has added to the impulse [N s], ≥ 0
    double impulse = 0;         ///< of the points [N s]
    double impulseChange = 0;   ///< that less the impulse of all samples [N s]
    double peak = 0;            ///< the largest force in size of the samples taken, with its sign [N]
    double peakTime = 0;        ///< its time in the table [s]
    double deviation = 0;       ///< largest distance of a sample from the lines between the points [N]
    std::string problem;        ///< why there is none; then there are no points
};

/// Requires samples without a problem. Impulses are those of the straight lines between samples.
ShapedSignal shapedSignal(const Samples& samples, const SignalRecipe& recipe,
                          const std::stop_token& stop = {});

/// Returns the value subtracted from all samples, as in the table.
double zeroOf(const Samples& samples, const SignalRecipe& recipe);

/// From the beginning to the end of the stretch around the largest value: where the signal has fallen to 2 %
/// of it on either side. Nothing where all values are the same.
struct RecordSpan {
    double from = 0;  ///< [s]
    double to = 0;    ///< [s]
};
std::optional<RecordSpan> spanAroundPeak(const Samples& samples, const SignalRecipe& recipe);

/// +1 or −1: the sign, after the zero line, of the largest value in size.
double signOfPeak(const Samples& samples, const SignalRecipe& recipe);

}  // namespace drillwave
