// SPDX-License-Identifier: GPL-3.0-or-later
// Interpretation of a record: what its table states, what is assumed, what the user must answer, and the
// force that follows once nothing is open.
#pragma once

#include <istream>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/signal/detected_table.h"
#include "core/signal/samples.h"
#include "core/signal/signal_quality.h"
#include "core/signal/signal_recipe.h"
#include "core/signal/signal_unit.h"
#include "core/text/message.h"

namespace drillwave {

/// Scale of the numbers of a table, given by the user: a factor, or a force per unit of the signal.
struct SignalScale {
    double factor = 1;       ///< factor, or force per unit of the signal [N per V, m/s or m/m]
    bool isPerUnit = false;  ///< whether `factor` is a force per unit of the signal, as in "50 kN/V"
    bool operator==(const SignalScale&) const = default;
};

/// Data about a record that the user enters because the table lacks them or gives them wrongly. Members
/// without a value are read from the table.
struct SignalOptions {
    std::optional<char> separator = {};
    std::optional<DecimalSign> decimal = {};
    std::optional<std::size_t> firstLine = {};
    TextEncoding encoding = TextEncoding::found;
    std::string timeColumn = {};  ///< column of times: its name, or its number from 1
    /// Column of the signal: its name, or its number from 1; two with "+" between them are averaged.
    std::string signalColumn = {};
    std::optional<double> timeUnit = {};  ///< unit of the column of times [s]
    std::optional<NamedSignalUnit> unit = {};
    std::optional<double> rate = {};  ///< sampling rate [Hz], which replaces a column of times
    std::optional<SignalScale> scale = {};
    /// Amplifier gain, supply of the bridge [V], bridge factor, gauge factor.
    std::optional<double> gain = {}, excitation = {}, bridge = {}, gaugeFactor = {};
    /// Cross-section [m²] and Young's modulus [Pa] of the bar that carries the strain gauges.
    std::optional<double> area = {}, modulus = {};
    /// Times in the table [s] between which the samples are averaged. The average is the zero line, which is
    /// subtracted from all samples.
    std::optional<std::pair<double, double>> zero = {};
    /// Times in the table [s] between which samples are used; without a value, from the beginning or to the
    /// end.
    std::optional<double> from = {}, to = {};
    bool invert = false;
    WrongRows wrongRows = WrongRows::refused;
    bool operator==(const SignalOptions&) const = default;
};

/// Properties of the bar that carries the strain gauges, taken from the scenario. Values in SignalOptions
/// replace them.
struct SignalBar {
    std::optional<double> area = {};       ///< cross-section A [m²]
    std::optional<double> modulus = {};    ///< Young's modulus E [Pa]
    std::optional<double> impedance = {};  ///< characteristic impedance Z [N s/m]
};

/// Source of a fact about a record: heading of the table, option of the user, estimate or assumption.
/// Estimates and assumptions must be confirmed by the user.
enum class FactSource { header, option, estimated, assumed };
std::string_view name(FactSource source);

struct SignalReading {
    DetectedTable table;
    TextEncoding encoding = TextEncoding::utf8;
    SampleSource source;
    std::string timeUnitText;  ///< unit of time as in the table or the option; empty if unknown
    FactSource timeFrom = FactSource::header;  ///< source of the unit of time, or of the sampling rate
    std::optional<double> rate = {};           ///< sampling rate [Hz], if there is no column of times
    std::optional<NamedSignalUnit> unit = {};
    FactSource unitFrom = FactSource::header;
    Samples samples;  ///< samples of the record: times in s, values in the unit of the table
    SignalQuality quality;
    /// Recipe by which `blow` was made from the samples. If its `points` is reduced, shapedSignal() gives
    /// the same blow with fewer points.
    SignalRecipe recipe;
    ShapedSignal blow;  ///< hammer force of the record [N], with all points; empty while a question is open
    /// Force [N], with its sign, that corresponds to the number 1 in the table; 0 if unknown.
    double forcePerNumber = 0;
    double zero = 0;   ///< zero line subtracted from all samples, in the unit of the table
    RecordSpan range;  ///< times of the table [s] at the start and the end of the blow
    /// Questions that the user must answer before the force is known: "unit", "rate", "time_unit", "column",
    /// "decimal", "area", "modulus", "bridge", "gauge_factor", "impedance".
    std::vector<std::string> questions;
    std::vector<SignalRemark> remarks;
    /// Reason why the text is not a table of samples; then all other members are invalid. Empty if it is one.
    Message problem;
    /// Whether the problem is a wrong option, such as a column that does not exist.
    bool isWrongOption = false;

    bool isTimeKnown() const;
    bool hasForce() const { return forcePerNumber != 0; }
    bool isOpen() const { return !questions.empty(); }
    /// Returns the unit of peak(): "kN" if the force is known, else the unit of the table. Empty if the unit
    /// of the table is unknown too.
    std::string_view peakUnit() const;
    /// Returns the largest deviation from the zero line in the unit peakUnit(), with its sign. If the force
    /// is known, compression is positive.
    double peak() const;
};

/// Reads a record from a stream and returns its interpretation. The stream is read several times from its
/// beginning. The sign is chosen so that the largest value is compression. Times in the options limit the
/// part that is used. Without such times, only the part around the peak is used for gauge signals, and for
/// forces with values of both signs.
SignalReading readSignal(std::istream& in, const SignalOptions& options, const SignalBar& bar = {},
                         const std::stop_token& stop = {});

/// Returns the transposed text of a table whose channels are rows, with one column for each channel.
std::string turnedTable(std::istream& in, const RowFormat& format, TextEncoding encoding);

/// Returns the scale read from a text of the user: a factor such as "50", or a force per unit of the signal
/// such as "50 kN/V" or "18 kN s/m". Returns nullopt for any other text.
std::optional<SignalScale> parseScale(std::string_view text);

}  // namespace drillwave
