// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/identify/parameter_verdicts.h"

#include <algorithm>
#include <cmath>

namespace drillwave {

namespace {

using Eigen::Index;

constexpr double identifiedShare = 0.2;     ///< half-width at most
constexpr double identifiedGap = 0.1e-3;    ///< [m]
constexpr double unloadedShare = 0.05;      ///< of the largest force
constexpr double contactDeviations = 3;     ///< of the misfit's noise
constexpr double leastContact = 0.015;      ///< of the peak: a smaller force says nothing of the rock
constexpr double widestKnown = 2.3;         ///< half-width of a logarithm: a factor 10 says nothing
constexpr double cornerReached = 0.98;      ///< of the largest force: a corner there has no effect
constexpr double hardeningRatio = 1.1;      ///< of residuals to noise
constexpr double hardeningMisfit = 0.0005;  ///< of the peak
constexpr double widestLog = 12;            ///< of an interval in logarithms, beyond it nothing is known

/// Force of the model within the window.
struct ForceSeen {
    double largest = 0;  ///< [N]
    bool hasUnloaded = false;
    double advance = 0;  ///< ∫2f dt/Z in the window [m]
};

ForceSeen forceSeen(RecordModel& model, const LawFit& fit) {
    const PreparedRecord& record = model.record();
    const ChainModel& chain = model.solved(fit.values);
    const double lag = fit.values[static_cast<Index>(model.find(UnknownKind::lag))];
    const double last = record.timeOf(model.firstReturning() + model.returningCount() - 1) -
                        record.roundTrip - lag - record.places.front().end.transitTime();
    ForceSeen seen;
    const double impedance = record.places.front().end.impedance;
    const std::vector<double>& f = model.incidentNow();
    for (std::size_t n = 0; n < chain.rockForce().size(); ++n) {
        const double t = model.gridStart() + static_cast<double>(n) * model.gridStep();
        if (t > last) break;
        seen.largest = std::max(seen.largest, chain.rockForce()[n]);
        if (chain.rockForce()[n] < (1 - unloadedShare) * seen.largest) seen.hasUnloaded = true;
        seen.advance += 2 * f[n] / impedance * model.gridStep();
    }
    return seen;
}

IdentifiedParameter parameterOf(const LawCandidate& chosen, const char* key, UnknownKind kind, double width) {
    const std::size_t unknown = chosen.model->find(kind);
    IdentifiedParameter parameter;
    parameter.key = key;
    const double value = chosen.fit.values[static_cast<Index>(unknown)];
    parameter.halfWidth = width;
    parameter.noise =
        chosen.errors.noise[static_cast<Index>(unknown)] * std::max(1.0, chosen.errors.misfit.ratio);
    if (parameter.isGap()) {
        parameter.value = value;
        parameter.low = std::max(0.0, value - width);
        parameter.high = value + width;
    } else {
        parameter.value = std::exp(value);
        parameter.low = std::exp(value - std::min(width, widestLog));
        parameter.high = std::exp(value + std::min(width, widestLog));
    }
    for (const BudgetEffect& row : chosen.errors.budget) {
        const double effect = std::abs(row.effect[static_cast<Index>(unknown)]);
        parameter.budget.push_back(
            {row.source, row.key, row.tolerance, std::string(row.unit), row.isAssumed, effect});
    }
    const double wave = chosen.errors.unexplainedEffect[static_cast<Index>(unknown)];
    parameter.budget.push_back({"unexplained_wave", "", chosen.errors.unexplained, "1", false, wave});
    return parameter;
}

/// Adds to the budget what other laws that fit as well widen: a row that all parameters have, even with
/// effect 0.
void addOtherLaws(IdentifiedParameter& parameter, double effect) {
    const auto row = std::ranges::find(parameter.budget, "law", &BudgetRow::source);
    if (row != parameter.budget.end())
        row->effect = std::hypot(row->effect, effect);
    else
        parameter.budget.push_back({"law", "", 0, "1", false, effect});
}

void judgeLog(IdentifiedParameter& parameter) {
    parameter.verdict =
        parameter.halfWidth <= identifiedShare ? ParameterVerdict::identified : ParameterVerdict::uncertain;
}

void notSeen(IdentifiedParameter& parameter, const char* reason) {
    parameter.verdict = ParameterVerdict::notSeen;
    parameter.reason = reason;
    parameter.low.reset();
    parameter.high.reset();
}

void judgeGamma(IdentifiedParameter& gamma) {
    judgeLog(gamma);
    const bool isOpenAbove = *gamma.high >= 1, isOpenBelow = *gamma.low <= 0.01;
    if (!isOpenAbove && !isOpenBelow) return;
    if (isOpenAbove) gamma.high.reset();
    if (isOpenBelow) gamma.low.reset();
    if (!gamma.low && !gamma.high)
        notSeen(gamma, "no_unloading");
    else
        gamma.verdict = ParameterVerdict::bounded;
}

void judgeGap(IdentifiedParameter& gap) {
    const bool isNarrow = gap.halfWidth <= identifiedGap || gap.halfWidth <= identifiedShare * gap.value;
    gap.verdict = isNarrow ? ParameterVerdict::identified : ParameterVerdict::uncertain;
    if (!isNarrow && *gap.low <= 0) {
        gap.verdict = ParameterVerdict::bounded;
        gap.low.reset();
    }
}

/// Widens an interval of logarithms to a half-width of at least `atLeast`.
void widen(IdentifiedParameter& parameter, double atLeast) {
    if (parameter.halfWidth >= atLeast) return;
    parameter.halfWidth = atLeast;
    parameter.low = parameter.value * std::exp(-atLeast);
    parameter.high = parameter.value * std::exp(atLeast);
}

/// A first line as steep as the way back may be the crater of a blow before, or a bit pressed into it: then
/// the second line is that of first loading.
void openCrater(RecordAnswer& answer) {
    IdentifiedParameter &stiffness = answer.parameters[0], &gamma = answer.parameters[1];
    const double slope = answer.parameters[4].value;
    if (slope >= 1 || std::log(gamma.value) + std::max(gamma.halfWidth, std::log(1.4)) < 0) return;
    const double way = -std::log(slope);
    widen(stiffness, way + answer.parameters[4].halfWidth + stiffness.halfWidth);
    widen(gamma, way + answer.parameters[4].halfWidth + gamma.halfWidth);
    answer.remarks.emplace_back("crater");
}

/// A rock that hardens at a corner and is not fully explained by it may harden at others too: below the first
/// of them it is softer by as much again.
void openHardening(const MisfitFound& misfit, RecordAnswer& answer) {
    const double slope = answer.parameters[4].value;
    if (slope <= 1 || misfit.ratio < hardeningRatio || misfit.misfit < hardeningMisfit) return;
    for (std::size_t i : {0, 1}) widen(answer.parameters[i], std::log(slope));
}

void fillCovariance(const LawTrials& trials, const std::vector<UnknownKind>& kinds, RecordAnswer& answer) {
    const LawCandidate& chosen = trials.chosen();
    const std::size_t count = kinds.size();
    std::vector<Index> at;
    for (const UnknownKind kind : kinds) at.push_back(static_cast<Index>(chosen.model->find(kind)));
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(static_cast<Index>(count), static_cast<Index>(count));
    const double scale = std::max(1.0, chosen.errors.misfit.ratio * chosen.errors.misfit.ratio);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < count; ++j) {
            double sum =
                scale * chosen.errors.draws.row(at[i]).dot(chosen.errors.draws.row(at[j])) / noiseDraws;
            for (const BudgetEffect& row : chosen.errors.budget)
                sum += row.effect[at[i]] * row.effect[at[j]] / (half95 * half95);
            covariance(static_cast<Index>(i), static_cast<Index>(j)) = sum;
        }
    // Independent causes make up the half-widths as reported.
    for (std::size_t i = 0; i < count; ++i) {
        const double wanted = std::pow(answer.parameters[i].halfWidth / half95, 2);
        double& own = covariance(static_cast<Index>(i), static_cast<Index>(i));
        own = std::max(own, wanted);
    }
    answer.covariance.assign(count, std::vector<double>(count));
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < count; ++j)
            answer.covariance[i][j] = covariance(static_cast<Index>(i), static_cast<Index>(j));
    for (const BudgetEffect& row : chosen.errors.budget) {
        if (row.source == "tail" || row.source == "timing" || row.source == "minimum" ||
            row.source == "gain_change")
            continue;
        std::vector<double> moved;
        for (const Index unknown : at) moved.push_back(row.effect[unknown]);
        answer.common.push_back(std::move(moved));
    }
}

}  // namespace

void fillParameters(const LawTrials& trials, const std::vector<double>& atLeast, RecordAnswer& answer) {
    const LawCandidate& chosen = trials.chosen();
    const Eigen::VectorXd widths = chosen.errors.halfWidths();
    std::vector<UnknownKind> kinds{UnknownKind::stiffness, UnknownKind::gamma, UnknownKind::gap};
    const char* keys[] = {"bit_rock.stiffness", "bit_rock.gamma", "bit_rock.gap", "bit_rock.corner.1.force",
                          "bit_rock.corner.1.slope"};
    if (chosen.name == "corner") {
        kinds.push_back(UnknownKind::cornerForce);
        kinds.push_back(UnknownKind::cornerSlope);
    }
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const double own = widths[static_cast<Index>(chosen.model->find(kinds[i]))];
        const double withLaws = widthWithLaws(trials, kinds[i], own);
        answer.parameters.push_back(parameterOf(chosen, keys[i], kinds[i], std::max(withLaws, atLeast[i])));
        addOtherLaws(answer.parameters.back(), std::sqrt(std::max(0.0, withLaws * withLaws - own * own)));
    }
    const ForceSeen force = forceSeen(*chosen.model, chosen.fit);
    const bool hasCorner =
        chosen.name == "corner" && answer.parameters[3].value <= cornerReached * force.largest;
    if (hasCorner) openCrater(answer);
    if (hasCorner) openHardening(chosen.errors.misfit, answer);
    fillCovariance(trials, kinds, answer);
    IdentifiedParameter& stiffness = answer.parameters[0];
    IdentifiedParameter& gamma = answer.parameters[1];
    IdentifiedParameter& gap = answer.parameters[2];
    if (answer.model == ModelVerdict::rejected) {
        for (IdentifiedParameter& parameter : answer.parameters) {
            parameter.verdict = ParameterVerdict::rejected;
            parameter.low.reset();
            parameter.high.reset();
        }
        return;
    }
    const PreparedRecord& record = chosen.model->record();
    judgeLog(stiffness);
    judgeGamma(gamma);
    judgeGap(gap);
    if (stiffness.halfWidth > widestKnown) notSeen(stiffness, "noise");
    for (std::size_t i = 3; i < answer.parameters.size(); ++i) judgeLog(answer.parameters[i]);
    if (chosen.name == "corner" && !hasCorner) {
        answer.parameters[3].verdict = ParameterVerdict::bounded;
        answer.parameters[3].low =
            std::min(force.largest, answer.parameters[3].value) * std::exp(-answer.parameters[3].halfWidth);
        answer.parameters[3].high.reset();
        notSeen(answer.parameters[4], "no_corner");
    }
    const double noise = std::max(contactDeviations * chosen.errors.misfit.noise, leastContact) * record.peak;
    if (force.largest < noise) {
        notSeen(stiffness, "no_contact");
        notSeen(gamma, "no_contact");
        for (std::size_t i = 3; i < answer.parameters.size(); ++i)
            notSeen(answer.parameters[i], "no_contact");
        gap.verdict = ParameterVerdict::bounded;
        gap.low = std::max(0.0, force.advance);
        gap.value = std::max(gap.value, *gap.low);
        gap.high.reset();
        return;
    }
    const double stiffest = answer.impedance / (4 * record.step);
    if (stiffness.value > stiffest) {
        stiffness.verdict = ParameterVerdict::bounded;
        stiffness.low = std::min(stiffest, stiffness.low.value_or(stiffest));
        stiffness.high.reset();
        notSeen(gamma, "front");
        return;
    }
    // A crater hides γ, but not that the record shows it: both of its values are in the interval.
    const double deviation = answer.has("crater") ? 0 : gamma.halfWidth / half95;
    if (answer.has("crater")) {
        gamma.low = gamma.value * std::exp(-gamma.halfWidth);
        gamma.high = 1;
        gamma.verdict = ParameterVerdict::uncertain;
    }
    if (!force.hasUnloaded || deviation > 1) notSeen(gamma, "no_unloading");
}

void openGap(RecordAnswer& answer) {
    for (IdentifiedParameter& parameter : answer.parameters) {
        if (!parameter.isGap()) continue;
        parameter.halfWidth = std::max(parameter.halfWidth, parameter.value);
        parameter.low = 0;
        judgeGap(parameter);
    }
}

}  // namespace drillwave
