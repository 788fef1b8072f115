// SPDX-License-Identifier: GPL-3.0-or-later
// Rock properties that a record shows, and how sure they are.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/study/identify/prepared_record.h"

namespace drillwave {

/// Whether the model agrees with the record.
enum class ModelVerdict { accepted, strained, rejected };
std::string_view name(ModelVerdict verdict);

/// Knowledge of one parameter.
enum class ParameterVerdict {
    identified,  ///< to 20 %, a gap to 0.1 mm or 20 %
    uncertain,   ///< a wider interval
    bounded,     ///< on one side only
    notSeen,     ///< the record does not show it
    rejected,    ///< the model does not hold
};
std::string_view name(ParameterVerdict verdict);

/// One cause of the half-width of a parameter.
struct BudgetRow {
    std::string
        source;  ///< "diameter", "length", "gain", "place", "step", "tail", "timing", "material", "law", …
    std::string key;       ///< of --known, may be empty
    double tolerance = 0;  ///< [unit]
    std::string unit;      ///< "m", "1"
    bool isAssumed = false;
    double effect = 0;  ///< on this parameter, 95 %; relative, of a gap [m]
};

struct IdentifiedParameter {
    std::string
        key;  ///< "bit_rock.stiffness", "bit_rock.gamma", "bit_rock.gap", "bit_rock.corner.1.force", …
    double value = 0;  ///< SI
    std::optional<double> low, high;
    ParameterVerdict verdict = ParameterVerdict::notSeen;
    std::string
        reason;  ///< of notSeen: "no_contact", "front", "no_unloading", "no_corner", "noise"; else empty
    double halfWidth = 0;  ///< 95 %; of the logarithm, of a gap [m]
    double noise = 0;      ///< part of it
    std::vector<BudgetRow> budget;
    bool isGap() const { return key == "bit_rock.gap"; }
};

/// A law that was tried, and how well it fits.
struct TriedLaw {
    std::string law;    ///< "bilinear", "corner", "crater", "power", "dashpot", "jump"
    double misfit = 0;  ///< m, share of the peak
    double ratio = 0;   ///< q
    std::vector<std::pair<std::string, double>> parameters;  ///< by key, SI
};

/// Zero line of one gauge, shares of the peak.
struct ZeroLine95 {
    double offset = 0;
    double slope = 0;  ///< in a millisecond
};

/// How model and record match.
struct MatchFigures {
    double misfit = 0, noise = 0, expected = 0, ratio = 0;
    double autocorrelation = 0;                 ///< of neighbouring residuals of b
    std::size_t samples = 0;                    ///< of b
    double from = 0, to = 0;                    ///< of the window after the front [s]
    double roundTrip = 0, roundTripOfFile = 0;  ///< between gauge and rock [s]
    double shiftOfSecond = 0, gainOfSecond = 1;
    double quiet = 0, unexplained = 0, before = 0, bending = 0;  ///< shares of the peak
    bool isClipped = false;
    double step = 0;  ///< of the recorder, share of the peak
    std::vector<ZeroLine95> zero;
    double droop = 0;         ///< 1 ms over the time constant
    double gainOfReturn = 1;  ///< gain of the returning wave over that of the incident one
    std::optional<double> dispersion, dispersionHalfWidth;
    std::optional<double> jumpTime;  ///< after the front [s]
};

/// A section size that would explain the record better.
struct SizeOff {
    std::string key;
    double change = 0;  ///< of a length [m], of a diameter [m]
};

/// Waves over time, for plots and files; times of the record [s], forces [N].
struct MatchCurves {
    std::vector<double> time, incident, measured, model, residual;
    std::vector<double> penetration, force, modelForce;  ///< at the same times, at the rock
    double front = 0;                                    ///< of the blow at the gauge near the bit
    double incidentEnd = 0;                              ///< of the blow there
    double quietFrom = 0;  ///< begin of the quiet stretch; of two gauges there is none
};

/// Prediction of the wave in the bar behind the specimen against its gauge, which no fit has used.
struct BlindCheck {
    double error = 0;  ///< rms of the difference, share of the largest measured value
    double shift = 0;  ///< by which the measured wave is later than the predicted one [s]
};

struct RecordAnswer {
    std::string file;
    std::size_t blow = 0;                  ///< from 0
    std::optional<RecordRefusal> refusal;  ///< then nothing else holds
    ModelVerdict model = ModelVerdict::rejected;
    std::string law;  ///< "bilinear", "corner" or that of the file
    std::vector<IdentifiedParameter> parameters;
    std::vector<std::vector<double>> covariance;  ///< of ln k, ln γ, gap, ln F1, ln s1, as parameters are
    std::vector<std::vector<double>> common;      ///< movements of the same by causes that all records share
    MatchFigures match;
    std::vector<TriedLaw> laws;
    std::vector<std::string> remarks;
    std::optional<SizeOff> sizeOff;
    MatchCurves curves;
    int sign = 1;
    double peak = 0;              ///< of the incident wave [N]
    double distanceThatFits = 0;  ///< of the near gauge from the bit face [m]
    double impedance = 0;         ///< Z of the gauge's section [N s/m]
    std::optional<BlindCheck> check;
    bool isFirst = false;  ///< other laws are still to be tried: intervals may widen

    bool has(std::string_view remark) const;
    const IdentifiedParameter* find(std::string_view key) const;
    /// Whether stiffness or gamma is identified or bounded and the model is not rejected.
    bool saysSomething() const;
};

}  // namespace drillwave
