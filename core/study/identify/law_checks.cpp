// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/identify/law_checks.h"

#include <algorithm>
#include <cmath>

#include "core/study/identify/gauge_pair.h"
#include "core/study/identify/law_search.h"

namespace drillwave {

namespace {

using Eigen::Index;

constexpr double countsWithin = 1.5;       ///< of the misfit of the answer: a law that counts
constexpr double countsBelow = 0.8;        ///< of that of the bilinear law
constexpr double cornerShare = 2.0 / 3;    ///< of the misfit that a corner replaces
constexpr double cornerReach = 0.95;       ///< of the largest force at most, of a corner that is the answer
constexpr double clearly = 0.85;           ///< of the misfit: a better fit than by chance
constexpr double jumpShare = 0.5;          ///< of that which a jump replaces
constexpr double jumpTolerance = 0.05;     ///< of the peak
constexpr double jumpMisfit = 0.002;       ///< of the peak: a smaller misfit needs no jump
constexpr double jumpExplains = 0.15;      ///< of Σr² at least
constexpr double checkedMisfit = 0.001;    ///< of the peak
constexpr double checkedRatio = 1.25;      ///< of the residuals to noise
constexpr double checkedDeviations = 2.5;  ///< of that ratio
constexpr double nearbyGain = 15;          ///< of Σr²: more than noise gives to one more unknown
constexpr double nearbyShare = 0.08;       ///< of Σr², where the bilinear law leaves more than noise
constexpr double likelyGain = 8;           ///< of Σr²: noise seldom gives as much
constexpr double unsureShare = 1.5;        ///< of the noise, at most, by a law that gains less
constexpr double nearbyFactor = 1.3;       ///< of the way to a law that gains as much
constexpr double craterShare = 1.05;       ///< of the Σr² of a corner, which has one unknown more
constexpr double unseenMisfit = 0.3;       ///< of the noise: smaller misfits are equal
constexpr double equalMisfit = 0.0012;     ///< of the peak: smaller misfits tell no law from another
constexpr double besideJump = 0.85;        ///< of the misfit of the bilinear law, of a law beside a jump
constexpr double strainedBilinear = 0.01;  ///< of the peak: beyond it the dispersion found is doubtful, too

LawCandidate candidateOf(std::string name, std::shared_ptr<RecordModel> model, LawFit fit,
                         const IdentifyQuestion& question, const std::vector<KnownSize>& sizes,
                         const std::stop_token& stop) {
    LawCandidate candidate{std::move(name), std::move(model), std::move(fit), {}};
    candidate.errors = fitErrors(*candidate.model, candidate.fit, question, sizes, question.seed, stop);
    return candidate;
}

/// Times at which a jump of the zero would explain most, at most three, 60 µs apart [s].
std::vector<double> jumpTimes(RecordModel& model, const LawFit& fit, const std::stop_token& stop) {
    const PreparedRecord& record = model.record();
    struct Scored {
        double time, share;
    };
    std::vector<Scored> scored;
    Eigen::VectorXd result;
    std::vector<const std::vector<double>*> signals;
    const std::vector<double> none(record.count(), 0);
    for (double time = 0; time < record.end - 20e-6 && !stop.stop_requested(); time += 10e-6) {
        std::vector<double> step(record.count(), 0);
        for (std::size_t i = record.front; i < record.count(); ++i)
            if (record.timeOf(i) >= time) step[i] = 0.01 * record.peak;
        signals.assign(record.gauges.size(), &none);
        signals[0] = &step;
        const SeparatedWaves waves = separateWaves(record, signals, record.transit);
        std::vector<double> quiet;
        for (std::size_t i = 0; i < model.quietCount(); ++i) quiet.push_back(step[model.firstQuiet() + i]);
        model.changedResiduals(fit.values, waves, quiet, result);
        const Eigen::VectorXd change = result - fit.residuals;
        const Eigen::VectorXd left = fit.left(change, fit.movedBy(change));
        const double own = left.squaredNorm();
        if (own < 1e-12 * change.squaredNorm() || own == 0) continue;
        const double explained = std::pow(left.dot(fit.residuals), 2) / own;
        scored.push_back({time, explained / fit.cost});
    }
    std::stable_sort(scored.begin(), scored.end(),
                     [](const Scored& a, const Scored& b) { return a.share > b.share; });
    std::vector<double> times;
    for (const Scored& one : scored) {
        if (one.share < jumpExplains || times.size() == 3) break;
        const bool isApart = std::all_of(times.begin(), times.end(),
                                         [&](double other) { return std::abs(other - one.time) >= 60e-6; });
        if (isApart) times.push_back(one.time);
    }
    return times;
}

std::optional<LawCandidate> jumpCandidate(const LawCandidate& bilinear, const IdentifyQuestion& question,
                                          const std::vector<KnownSize>& sizes,
                                          std::optional<double>& bestTime, const std::stop_token& stop) {
    std::optional<LawCandidate> best;
    const auto tryAt = [&](double time) {
        auto model = std::make_shared<RecordModel>(*bilinear.model);
        model->setJump(time, jumpTolerance);
        LawFit fit;
        fit.law = TrialLaw::bilinear;
        fit.values = bilinear.fit.values;
        fit.values.conservativeResize(fit.values.size() + 1);
        fit.values[fit.values.size() - 1] = 0;
        refit(*model, fit, stop);
        if (best && fit.cost >= best->fit.cost) return;
        best = LawCandidate{"jump", model, fit, {}};
        bestTime = time;
    };
    for (const double time : jumpTimes(*bilinear.model, bilinear.fit, stop)) tryAt(time);
    if (bestTime) {
        const double middle = *bestTime;
        tryAt(middle - 6e-6);
        tryAt(middle + 6e-6);
    }
    if (best) best = candidateOf("jump", best->model, best->fit, question, sizes, stop);
    return best;
}

/// Adds to the budget of the bilinear law what a crater, a corner, a power law and a dashpot near it change,
/// and returns whether one of them gains more than noise does. Each contains the bilinear law, so clean
/// records stay. `jump` is the time of the jump that the model has.
bool addNearbyLaws(LawCandidate& bilinear, const IdentifyQuestion& question, const SizeTolerances& sizes,
                   std::optional<double> jump, const std::stop_token& stop) {
    BudgetEffect row{"law", "", 0, "1", false, Eigen::VectorXd::Zero(bilinear.fit.values.size())};
    bool gains = false;
    for (const TrialLaw law : {TrialLaw::crater, TrialLaw::corner, TrialLaw::power, TrialLaw::dashpot}) {
        const PreparedRecord& record = bilinear.model->record();
        if (stop.stop_requested() || (law == TrialLaw::dashpot && record.places.front().end.bitMass > 0))
            continue;
        RecordModel model(record, question, sizes, law);
        if (jump) model.setJump(*jump, jumpTolerance);
        const LawFit fit = fitNearby(model, *bilinear.model, bilinear.fit, stop);
        const double gain = bilinear.fit.cost - fit.cost;
        const bool isSure = gain > std::max(nearbyGain, nearbyShare * bilinear.fit.cost);
        gains = gains || isSure;
        // Noise moves one more unknown, too; its half-width has that.
        const double share = isSure ? nearbyFactor : std::sqrt(std::clamp(gain / nearbyGain, 0.0, 1.0));
        for (const UnknownKind kind : {UnknownKind::stiffness, UnknownKind::gamma, UnknownKind::gap}) {
            const auto own = static_cast<Index>(bilinear.model->find(kind));
            const double way =
                std::abs(fit.values[static_cast<Index>(model.find(kind))] - bilinear.fit.values[own]);
            const double most = gain > likelyGain ? INFINITY : unsureShare * bilinear.errors.noise[own];
            row.effect[own] = std::max(row.effect[own], std::min(share * way, most));
        }
    }
    bilinear.errors.budget.push_back(std::move(row));
    return gains;
}

/// Adds to the budget what other solutions widen: to another minimum and its own half-width, and to where Σr²
/// has risen as much as 95 % of the records allow.
void addNearbySolutions(LawCandidate& bilinear) {
    constexpr double rise95 = 3.84, leastRise = 0.5;
    const Eigen::ArrayXd own = bilinear.errors.halfWidths().array();
    BudgetEffect row{"minimum", "", 0, "1", false, Eigen::VectorXd::Zero(own.size())};
    for (const NearbySolution& other : bilinear.fit.nearby) {
        const Eigen::ArrayXd way = (other.values - bilinear.fit.values).array().abs();
        const Eigen::ArrayXd wanted = other.isMinimum
                                          ? Eigen::ArrayXd(way + own)
                                          : way * std::sqrt(rise95 / std::max(other.rise, leastRise));
        row.effect = row.effect.cwiseMax((wanted.square() - own.square()).max(0).sqrt().matrix());
    }
    bilinear.errors.budget.push_back(std::move(row));
}

/// The same model with a gain that may fall further up to the peak than that of a usual amplifier.
RecordModel overloaded(RecordModel model) {
    constexpr double further = 5;
    Unknown& curvature = model.unknowns()[model.shapeUnknown("curvature")];
    curvature.low *= further;
    curvature.high *= further;
    curvature.deviation *= further;
    return model;
}

/// Adds an independent cause to a row of the budget: a half-width of one unknown.
void addEffect(BudgetEffect& row, const RecordModel& model, UnknownKind kind, double halfWidth) {
    double& effect = row.effect[static_cast<Index>(model.find(kind))];
    effect = std::hypot(effect, halfWidth);
}

/// Adds to the budget the effect of a law that was not tried, if the answer leaves more than noise. The full
/// effect counts from a misfit of 0.1 % of the peak and 1.25 times the noise, none below 0.05 % or 1.1 times.
void addUntriedLaws(LawCandidate& answer) {
    constexpr double onStiffness = 0.055, onGamma = 0.04;  // half-widths of logarithms
    const MisfitFound& found = answer.errors.misfit;
    const double share = std::clamp(found.misfit / (checkedMisfit / 2) - 1, 0.0, 1.0) *
                         std::clamp((found.ratio - 1.1) / (checkedRatio - 1.1), 0.0, 1.0);
    auto row = std::ranges::find(answer.errors.budget, "law", &BudgetEffect::source);
    if (row == answer.errors.budget.end())
        row = answer.errors.budget.insert(
            row, {"law", "", 0, "1", false, Eigen::VectorXd::Zero(answer.fit.values.size())});
    addEffect(*row, *answer.model, UnknownKind::stiffness, share * onStiffness);
    addEffect(*row, *answer.model, UnknownKind::gamma, share * onGamma);
}

/// Adds to the budget how far the answer is from that with the same gain for both waves, and where the gain
/// falls up to the peak as much as is allowed, from that of an overload. Each way counts by what Σr² gains.
/// A gain that differs between the waves is seldom constant within them: filters and gauges that come off
/// change it with time, and that moves the gap most.
void addNearbyGains(LawCandidate& bilinear, const std::stop_token& stop) {
    constexpr double atBound = 0.9, leastTold = 0.01;
    constexpr double onStiffness = 0.06, onGamma = 0.05, onGap = 0.1e-3;  // half-widths, the last in m
    BudgetEffect row{"gain_change", "", 0, "1", false, Eigen::VectorXd::Zero(bilinear.fit.values.size())};
    const auto addWay = [&](RecordModel model, Eigen::VectorXd values) {
        const double gain = std::abs(minimise(model, values, 40, stop) - bilinear.fit.cost);
        const double share = gain > likelyGain ? 1 : std::sqrt(gain / nearbyGain);
        row.effect = row.effect.cwiseMax(share * (values - bilinear.fit.values).cwiseAbs());
        return gain;
    };
    RecordModel equal = *bilinear.model;
    const std::size_t ofReturn = equal.shapeUnknown("gain"), curvature = equal.shapeUnknown("curvature");
    const auto value = [&](std::size_t unknown) { return bilinear.fit.values[static_cast<Index>(unknown)]; };
    equal.unknowns()[ofReturn].isHeld = true;
    Eigen::VectorXd values = bilinear.fit.values;
    values[static_cast<Index>(ofReturn)] = 0;
    if (addWay(std::move(equal), values) > std::max(nearbyGain, nearbyShare * bilinear.fit.cost) &&
        std::abs(value(ofReturn)) > leastTold) {
        bilinear.errors.remarks.emplace_back("gain_changes");
        addEffect(row, *bilinear.model, UnknownKind::stiffness, onStiffness);
        addEffect(row, *bilinear.model, UnknownKind::gamma, onGamma);
        addEffect(row, *bilinear.model, UnknownKind::gap, onGap * bilinear.model->record().gapScale);
    }
    if (std::abs(value(curvature)) > atBound * bilinear.model->unknowns()[curvature].high)
        addWay(overloaded(*bilinear.model), bilinear.fit.values);
    bilinear.errors.budget.push_back(std::move(row));
}

/// Returns the fit of the bilinear law from the solution with a corner, if that has hardly a corner and the
/// fit leaves clearly less than the one found before. A search for the corner begins with other shares of
/// dispersion and without zero lines, and can find a minimum that the search for the bilinear law has missed.
ModelFit bilinearNear(const LawCandidate& corner, const LawCandidate& bilinear,
                      std::shared_ptr<RecordModel> model, const std::stop_token& stop) {
    constexpr double noCorner = 0.1;  // of the logarithm of the slope
    const double slope = corner.fit.values[static_cast<Index>(corner.model->find(UnknownKind::cornerSlope))];
    if (std::abs(slope) > noCorner || corner.misfit() > cornerShare * bilinear.misfit()) return {};
    LawFit fit = fitNearby(*model, *corner.model, corner.fit, stop);
    refit(*model, fit, stop);
    const MisfitFound& found = bilinear.errors.misfit;
    if (stop.stop_requested() ||
        misfitOf(*model, fit, found.noise, found.scatter).misfit > clearly * found.misfit)
        return {};
    return {std::move(model), std::move(fit)};
}

/// Whether a law counts beside the answer.
bool counts(const LawTrials& trials, std::size_t i) {
    const LawCandidate& candidate = trials.candidates[i];
    const MisfitFound& found = trials.chosen().errors.misfit;
    const double answer = std::max({found.misfit, unseenMisfit * found.noise, equalMisfit});
    const double bilinear = trials.candidates.front().misfit();
    if (i == trials.answer) return false;
    // A jump fits half of anything: another law that explains some of the same stays open.
    if (trials.chosen().name == "jump" && candidate.misfit() <= besideJump * bilinear) return true;
    if (candidate.misfit() > countsWithin * answer) return false;
    return i == 0 || candidate.misfit() <= countsBelow * bilinear;
}

/// `mayRestart` allows a second beginning, from another solution of the bilinear law.
LawTrials lawsFrom(ModelFit known, bool mayRestart, const PreparedRecord& record,
                   const IdentifyQuestion& question, const std::vector<KnownSize>& sizes,
                   const std::stop_token& stop, const std::function<void(const LawTrials&)>& showFirst) {
    LawTrials trials;
    const SizeTolerances tolerances = sizeTolerances(sizes, record.places.front());
    const auto modelOf = [&](TrialLaw law) {
        return std::make_shared<RecordModel>(record, question, tolerances, law);
    };
    if (!known.model) {
        known.model = modelOf(TrialLaw::bilinear);
        known.fit = fitFromStarts(*known.model, stop);
    }
    auto& [model, fit] = known;
    searchMinima(*model, fit, stop);
    trials.candidates.push_back(candidateOf("bilinear", model, std::move(fit), question, sizes, stop));
    addNearbySolutions(trials.candidates[0]);
    addNearbyGains(trials.candidates[0], stop);
    if (stop.stop_requested()) return trials;
    showFirst(trials);
    const auto tryLaw = [&](const char* name, TrialLaw law) {
        auto other = modelOf(law);
        LawFit found = fitFrom(*other, *trials.candidates[0].model, trials.candidates[0].fit,
                               trials.candidates[0].misfit() > strainedBilinear, stop);
        LawCandidate candidate = candidateOf(name, other, std::move(found), question, sizes, stop);
        // A law that noise can move far would excuse its misfit with that: noise is that of the bilinear law
        // at most.
        const MisfitFound& bilinear = trials.candidates[0].errors.misfit;
        if (candidate.errors.misfit.noise > bilinear.noise)
            candidate.errors.misfit = misfitOf(*other, candidate.fit, bilinear.noise, bilinear.scatter);
        trials.candidates.push_back(std::move(candidate));
    };
    const MisfitFound misfit = trials.candidates[0].errors.misfit;
    const bool isBent = addNearbyLaws(trials.candidates[0], question, tolerances, {}, stop);
    const UsedUp used = usedUp(*model, trials.candidates[0].fit);
    const bool isOpen = isBent || !isAccepted(misfit) ||
                        (misfit.ratio > 1.1 && std::max(used.zeroLines, used.droop) > 1) ||
                        (misfit.ratio > std::max(checkedRatio, 1 + checkedDeviations * misfit.scatter) &&
                         misfit.misfit > checkedMisfit);
    if (!isOpen && question.law != LawChoice::corner) {
        addUntriedLaws(trials.candidates[0]);
        return trials;
    }
    tryLaw("corner", TrialLaw::corner);
    ModelFit near;
    if (mayRestart)
        near = bilinearNear(trials.candidates[1], trials.candidates[0], modelOf(TrialLaw::bilinear), stop);
    if (near.model) return lawsFrom(std::move(near), false, record, question, sizes, stop, showFirst);
    if (isOpen) {
        tryLaw("crater", TrialLaw::crater);
        tryLaw("power", TrialLaw::power);
        if (record.places.front().end.bitMass == 0) tryLaw("dashpot", TrialLaw::dashpot);
        auto further = std::make_shared<RecordModel>(overloaded(*model));
        LawFit overload = trials.candidates[0].fit;
        refit(*further, overload, stop);
        trials.candidates.push_back(
            candidateOf("overload", further, std::move(overload), question, sizes, stop));
        if (misfit.misfit > jumpMisfit)
            if (auto jump = jumpCandidate(trials.candidates[0], question, sizes, trials.jumpTime, stop))
                trials.candidates.push_back(std::move(*jump));
    }
    const auto indexOf = [&](const char* name) {
        for (std::size_t i = 0; i < trials.candidates.size(); ++i)
            if (trials.candidates[i].name == name) return i;
        return trials.candidates.size();
    };
    const std::size_t corner = indexOf("corner"), jump = indexOf("jump");
    if (question.law == LawChoice::corner) {
        trials.answer = corner;
    } else if (question.law == LawChoice::automatic) {
        const LawCandidate& other = trials.candidates[corner];
        const bool bilinearHolds = isAccepted(misfit);
        const double force =
            std::exp(other.fit.values[static_cast<Index>(other.model->find(UnknownKind::cornerForce))]);
        // One at the very peak takes what is no corner, such as a gain that falls.
        const bool isReached = !bilinearHolds || force < cornerReach * largestForce(*other.model, other.fit);
        if (isReached && ((isAccepted(other.errors.misfit) && !bilinearHolds &&
                           other.misfit() <= clearly * misfit.misfit) ||
                          other.misfit() <= cornerShare * misfit.misfit))
            trials.answer = corner;
        // A crater begins as steep as the rock springs back, as a corner can.
        if (trials.answer == corner && indexOf("crater") < trials.candidates.size() &&
            trials.candidates[indexOf("crater")].fit.cost <= craterShare * other.fit.cost)
            trials.answer = indexOf("crater");
        if (jump < trials.candidates.size()) {
            const LawCandidate& jumped = trials.candidates[jump];
            const UsedUp zero = usedUp(*jumped.model, jumped.fit);
            // A jump that needs zero lines beyond their tolerance beside it is none.
            if (jumped.misfit() <= jumpShare * trials.candidates[0].misfit() &&
                jumped.misfit() <= trials.chosen().misfit() && std::max(zero.zeroLines, zero.droop) <= 1)
                trials.answer = jump;
        }
    }
    if (jump < trials.candidates.size() && trials.answer == jump)
        addNearbyLaws(trials.candidates[jump], question, tolerances, trials.jumpTime, stop);
    if (trials.answer != 0) addNearbyGains(trials.candidates[trials.answer], stop);
    addUntriedLaws(trials.candidates[trials.answer]);
    const double left = trials.chosen().misfit();
    for (std::size_t i = 0; i < trials.candidates.size(); ++i) {
        const std::string& name = trials.candidates[i].name;
        if ((name == "power" || name == "dashpot") && trials.candidates[i].misfit() < 0.5 * left &&
            left > checkedMisfit)
            trials.isStrained = true;
        if (counts(trials, i)) trials.isLawOpen = true;
    }
    return trials;
}

}  // namespace

bool isAccepted(const MisfitFound& misfit) {
    return misfit.ratio <= 1.3 || misfit.misfit <= 0.01;
}

LawTrials tryLaws(const PreparedRecord& record, const IdentifyQuestion& question,
                  const std::vector<KnownSize>& sizes, ModelFit known, const std::stop_token& stop,
                  const std::function<void(const LawTrials&)>& showFirst) {
    return lawsFrom(std::move(known), true, record, question, sizes, stop, showFirst);
}

double widthWithLaws(const LawTrials& trials, Unknown::Kind kind, double own) {
    double width = own;
    const LawCandidate& answer = trials.chosen();
    const std::size_t unknown = answer.model->find(kind);
    const double value = answer.fit.values[static_cast<Index>(unknown)];
    for (std::size_t i = 0; i < trials.candidates.size(); ++i) {
        if (!counts(trials, i)) continue;
        const LawCandidate& other = trials.candidates[i];
        const std::size_t same = other.model->find(kind);
        if (same >= other.model->unknowns().size()) continue;
        const double theirs = other.errors.halfWidths()[static_cast<Index>(same)];
        const double distance = std::abs(other.fit.values[static_cast<Index>(same)] - value);
        width = std::max(width, distance + std::min(theirs, own));
    }
    // A jump takes what the bilinear law calls a gap; where in the blow it stands, the record hardly says.
    if (answer.name == "jump" && kind == Unknown::Kind::gap) {
        const LawCandidate& bilinear = trials.candidates.front();
        const std::size_t same = bilinear.model->find(kind);
        width = std::max(width, std::abs(bilinear.fit.values[static_cast<Index>(same)] - value));
    }
    return width;
}

bool gapMayBeBend(const LawTrials& trials, const PreparedRecord& record, const IdentifyQuestion& question,
                  const std::vector<KnownSize>& sizes, const std::stop_token& stop) {
    RecordModel model(record, question, sizeTolerances(sizes, record.places.front()), TrialLaw::power);
    model.unknowns()[model.find(Unknown::Kind::gap)].high = 0;
    const LawFit fit = fitFrom(model, *trials.candidates[0].model, trials.candidates[0].fit, false, stop);
    const MisfitFound& answer = trials.chosen().errors.misfit;
    const MisfitFound bend = misfitOf(model, fit, answer.noise, answer.scatter);
    return bend.rms <= (1 + answer.scatter / 2) * answer.rms;
}

}  // namespace drillwave
