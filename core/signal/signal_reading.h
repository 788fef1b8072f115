// SPDX-License-Identifier: GPL-3.0-or-later
// A record as it is understood: what its table states, what is assumed, what must be asked, and the force
// that follows when nothing is open.
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

/// Scale of the numbers of a table, given by hand: a factor of a force, or newtons per volt.
struct SignalScale {
    double factor = 1;       ///< as typed
    bool isPerUnit = false;  ///< in N for one V, m/s or m/m of the column: "50 kN/V"
    bool operator==(const SignalScale&) const = default;
};

/// Facts about a record that its table does not state, or states wrongly. Empty ones are taken from the
/// table.
struct SignalOptions {
    std::optional<char> separator = {};
    std::optional<DecimalSign> decimal = {};
    std::optional<std::size_t> firstLine = {};
    TextEncoding encoding = TextEncoding::found;
    std::string timeColumn = {};          ///< name, or number from 1
    std::string signalColumn = {};        ///< by name or number; two with a plus sign between are averaged
    std::optional<double> timeUnit = {};  ///< [s]
    std::optional<NamedSignalUnit> unit = {};
    std::optional<double> rate = {};  ///< [Hz]
    std::optional<SignalScale> scale = {};
    std::optional<double> gain = {}, excitation = {}, bridge = {}, gaugeFactor = {};  ///< excitation in V
    std::optional<double> area = {}, modulus = {};                                    ///< [m²], [Pa]
    std::optional<std::pair<double, double>> zero = {};  ///< times of the table whose mean is zero [s]
    std::optional<double> from = {}, to = {};            ///< times of the table [s]
    bool invert = false;
    WrongRows wrongRows = WrongRows::refused;
    bool operator==(const SignalOptions&) const = default;
};

/// The bar that a gauge is on, where a scenario tells it: an option goes first.
struct SignalBar {
    std::optional<double> area = {};       ///< [m²]
    std::optional<double> modulus = {};    ///< [Pa]
    std::optional<double> impedance = {};  ///< [N s/m]
};

/// Source of a fact about a record. Assumed or estimated facts are also questions.
enum class FactSource { header, option, estimated, assumed };
std::string_view name(FactSource source);

struct SignalReading {
    DetectedTable table;
    TextEncoding encoding = TextEncoding::utf8;
    SampleSource source;
    std::string timeUnitText;  ///< as the table or the option has it, empty where it is not known
    FactSource timeFrom = FactSource::header;  ///< of the unit of time, or of the rate
    std::optional<double> rate = {};           ///< without a column of times [Hz]
    std::optional<NamedSignalUnit> unit = {};
    FactSource unitFrom = FactSource::header;
    Samples samples;  ///< in s where time is known, else in the unit of the table
    SignalQuality quality;
    SignalRecipe recipe;  ///< by which the blow was made; fewer points make a shorter one
    ShapedSignal blow;    ///< what is taken of it [N], all points kept; empty while a question bears on it
    double forcePerNumber = 0;  ///< N, with the sign; 0 where it is not known
    double zero = 0;            ///< taken off, as in the table
    RecordSpan range;           ///< [s]
    std::vector<std::string>
        questions;  ///< "unit", "rate", "time_unit", "column", "decimal", "area", "modulus"
    std::vector<SignalRemark> remarks;
    Message problem;             ///< why it is no table of samples; then nothing else holds
    bool isWrongOption = false;  ///< the problem is one of an option: a column that is not there

    bool isTimeKnown() const;
    bool hasForce() const { return forcePerNumber != 0; }
    bool isOpen() const { return !questions.empty(); }
    /// "kN" where the force is known, else the unit of the table, empty where that is not known either.
    std::string_view peakUnit() const;
    double peak() const;  ///< largest value over the zero line in peakUnit(), positive where it presses
};

/// Reads a record that can be rewound. Signs and ranges are proposed as in the window: the largest value
/// presses; of a gauge, and of a force with noise, the stretch around the peak is the blow.
SignalReading readSignal(std::istream& in, const SignalOptions& options, const SignalBar& bar = {},
                         const std::stop_token& stop = {});

/// The text of a table whose channels are rows, turned: one column for each.
std::string turnedTable(std::istream& in, const RowFormat& format, TextEncoding encoding);

/// "50", "50 kN/V", "18 kN s/m", or nothing.
std::optional<SignalScale> parseScale(std::string_view text);

}  // namespace drillwave
