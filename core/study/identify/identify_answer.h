// SPDX-License-Identifier: GPL-3.0-or-later
// Rock properties identified from a record, with their uncertainty.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/study/identify/prepared_record.h"

namespace drillwave {

/// Verdict on how well the model agrees with the record: well, with reservations (`strained`), or not.
enum class ModelVerdict { accepted, strained, rejected };
std::string_view name(ModelVerdict verdict);

/// Verdict on how well the record determines a parameter.
enum class ParameterVerdict {
    identified,  ///< interval within ±20 %; for a gap within ±0.1 mm or ±20 %
    uncertain,   ///< interval wider than ±20 %; for a gap also wider than ±0.1 mm
    bounded,     ///< only a lower or only an upper bound is known
    notSeen,     ///< the record contains no information about the parameter
    rejected,    ///< the model does not agree with the record, so no parameter is given
};
std::string_view name(ParameterVerdict verdict);

/// Contribution of one source of error to the 95 % half-width of one parameter.
struct BudgetRow {
    /// Source of the error: "diameter", "length", "gain", "place" (gauge position), "step" (resolution of the
    /// recorder), "tail" (stray waves after the blow), "timing", "material", "law", …
    std::string source;
    std::string key;       ///< key of option --known that sets this tolerance; empty if there is none
    double tolerance = 0;  ///< 95 % tolerance of the source, in `unit`
    std::string unit;      ///< unit of the tolerance: "m", "m^2", "N", "s" or "1"
    bool isAssumed = false;
    double effect = 0;  ///< effect on this parameter as a 95 % half-width: relative, for a gap in metres
};

struct IdentifiedParameter {
    /// Parameter key: "bit_rock.stiffness", "bit_rock.gamma", "bit_rock.gap", "bit_rock.corner.1.force", …
    std::string key;
    double value = 0;  ///< identified value, in SI units
    std::optional<double> low, high;
    ParameterVerdict verdict = ParameterVerdict::notSeen;
    /// Reason for the verdict notSeen: "no_contact", "front" (rock too stiff for the time step),
    /// "no_unloading", "no_corner" or "noise". Empty for other verdicts.
    std::string reason;
    /// 95 % half-width of the natural logarithm of the parameter; for the gap, of its value in metres.
    double halfWidth = 0;
    double noise = 0;  ///< part of `halfWidth` that is caused by noise, in the same unit
    std::vector<BudgetRow> budget;
    bool isGap() const { return key == "bit_rock.gap"; }
};

/// Rock law that was fitted to the record, and how well it fits.
struct TriedLaw {
    std::string law;    ///< name of the law: "bilinear", "corner", "crater", "power", "dashpot" or "jump"
    double misfit = 0;  ///< m, the rms misfit beyond noise, as a share of the peak force
    double ratio = 0;   ///< q, the ratio of the rms residual to that expected from noise
    /// Fitted parameters of this law: pairs of key and value in SI units.
    std::vector<std::pair<std::string, double>> parameters;
};

/// Fitted zero line of one gauge. Its values are shares of the peak force.
struct ZeroLine95 {
    double offset = 0;
    double slope = 0;  ///< slope of the zero line, as a share of the peak force per millisecond
};

/// Figures that describe how well the model and the record of an identification agree.
struct MatchFigures {
    double misfit = 0, noise = 0, expected = 0, ratio = 0;
    /// Autocorrelation of neighbouring residuals of the returning wave b, −1 … 1; about 0 for pure noise.
    double autocorrelation = 0;
    std::size_t samples = 0;  ///< number of samples of the returning wave b that are compared
    double from = 0, to = 0;  ///< start and end of the compared window, after the front [s]
    /// Round-trip time of a wave between gauge and rock [s]: the fitted one, and the one computed from the
    /// scenario file.
    double roundTrip = 0, roundTripOfFile = 0;
    double shiftOfSecond = 0, gainOfSecond = 1;
    /// Amplitudes as shares of the peak force. They belong to stray waves between blow and reflection,
    /// unexplained waves, waves before the front, and bending.
    double quiet = 0, unexplained = 0, before = 0, bending = 0;
    bool isClipped = false;
    double step = 0;  ///< smallest step between recorded values, as a share of the peak force
    std::vector<ZeroLine95> zero;
    double droop = 0;         ///< droop of the amplifier: 1 ms divided by its time constant
    double gainOfReturn = 1;  ///< gain for the returning wave divided by that for the incident wave
    std::optional<double> dispersion, dispersionHalfWidth;
    /// Time of the fitted jump of the gauge's zero level, measured from the front of the blow [s]; empty
    /// without a jump.
    std::optional<double> jumpTime;
};

/// Change of one size of a section (length, diameter or area) that would explain the record better.
struct SizeOff {
    std::string key;
    double change = 0;  ///< change of a length or diameter [m], or of an area [m²]
};

/// Measured and modelled waves and the response of the rock over time, for plots and files. Times are those
/// of the recording [s], forces are in newtons.
struct MatchCurves {
    std::vector<double> time, incident, measured, model, residual;
    /// Penetration [m], and measured and modelled force at the rock [N], at the same indices as `time`. They
    /// are shifted in time by the travel of the wave from the rock to the gauge.
    std::vector<double> penetration, force, modelForce;
    double front = 0;        ///< time at which the front of the blow reaches the gauge near the bit [s]
    double incidentEnd = 0;  ///< time at which the incident wave ends at that gauge [s]
    /// Time after which the gauge shows no more of the blow until the reflection arrives [s]; not used with
    /// two gauges.
    double quietFrom = 0;
};

/// Comparison of the predicted wave in the bar behind the specimen with a gauge there, which the fit did not
/// use.
struct BlindCheck {
    double error = 0;  ///< rms of the difference, as a share of the largest measured value
    /// Time by which the measured wave is later than the predicted one [s]; negative if it is earlier.
    double shift = 0;
    /// Factor on the predicted wave that fits the measured one best. If it is far from 1, the gains of the
    /// two gauges or the areas of the two bars differ.
    double gain = 1;
    double scaledError = 0;  ///< like `error`, for the prediction times `gain`
};

/// Loading curve of the rock as identified, with at most one corner.
struct IdentifiedLaw {
    double stiffness = 1;           ///< slope of the first line [N/m], > 0
    double cornerForce = INFINITY;  ///< force at the corner [N]
    double cornerSlope = 1;         ///< slope beyond the corner, as a share of the stiffness; > 0

    /// Returns the penetration [m] at a force [N] ≥ 0, counted from the untouched rock beyond the gap.
    double penetrationAt(double force) const {
        const double before = std::min(force, cornerForce);
        return before / stiffness + (force - before) / (cornerSlope * stiffness);
    }
};

struct RecordAnswer {
    std::string file;
    std::size_t blow = 0;  ///< index of the blow in the record, from 0
    /// Reason why the record cannot be used; the other results are then not valid. Empty if it can be used.
    std::optional<RecordRefusal> refusal;
    ModelVerdict model = ModelVerdict::rejected;
    /// Rock law of the result: "bilinear", "corner", or "file" for the law of the scenario file.
    std::string law;
    std::vector<IdentifiedParameter> parameters;
    /// Covariance of the parameters, in the order of `parameters`. They are ln k (stiffness), ln γ (gamma),
    /// gap [m] and, with a corner, ln F1 (its force) and ln s1 (slope beyond).
    std::vector<std::vector<double>> covariance;
    /// Changes of the parameters (as in `covariance`) by error sources common to all records, such as
    /// tolerances. They are 95 % half-widths, one row for each source.
    std::vector<std::vector<double>> common;
    MatchFigures match;
    std::vector<TriedLaw> laws;
    std::vector<std::string> remarks;
    std::optional<SizeOff> sizeOff;
    MatchCurves curves;
    int sign = 1;
    double peak = 0;  ///< peak force of the incident wave [N]
    /// Distance from the bit face at which the gauge near the bit fits the record best [m].
    double distanceThatFits = 0;
    double impedance = 0;  ///< characteristic impedance Z of the gauge's section [N s/m]
    std::optional<BlindCheck> check;
    /// Whether this is a preliminary result. Other rock laws are still to be tried, which may widen the
    /// intervals.
    bool isFirst = false;

    bool has(std::string_view remark) const;
    const IdentifiedParameter* find(std::string_view key) const;
    bool hasTwoGauges() const { return match.zero.size() > 1; }
    /// Returns whether the section with the gauge ends at the rock. If so, the sum of incident and returning
    /// wave is the force on the rock.
    bool hasGaugeAtRock() const;
    /// Returns the identified loading curve of the rock; empty if no stiffness was found.
    std::optional<IdentifiedLaw> loadingLaw() const;
    /// Returns the incident wave as pairs of time from its front [s] and force [N] ≥ 0, from its front to its
    /// end.
    std::vector<std::pair<double, double>> incidentWave() const;
    /// Returns whether the result contains information about the rock. The model must not be rejected, and
    /// stiffness or gamma must be identified or bounded. With the law of the scenario file, it is enough that
    /// the model is not rejected.
    bool saysSomething() const;
};

}  // namespace drillwave
