// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/identify/identify_record.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/study/identify/blind_check.h"
#include "core/study/identify/law_checks.h"
#include "core/study/identify/law_search.h"
#include "core/study/identify/parameter_verdicts.h"

namespace drillwave {

namespace {

using Eigen::Index;

constexpr double strainedMisfit = 0.01;  ///< of the peak
constexpr double roughMisfit = 0.005;    ///< of the peak, where it is not noise
constexpr double roughRatio = 5;         ///< of the residuals to noise
constexpr double rejectedMisfit = 0.05;  ///< of the peak
constexpr double rejectedWave = 0.08;    ///< unexplained, of the peak
constexpr double usedUpMisfit = 0.003;   ///< of the peak
constexpr double doubtfulWidth = 0.35;   ///< of a logarithm: no answer to 20 %
constexpr double usedUpWidth = 0.7;      ///< of logarithms at least, where a specimen bends the zero lines
constexpr double tooFar = 1.5;           ///< tolerances that a zero line or a size may take
constexpr double arrivalFrom = 25e-6;    ///< [s]
constexpr double lagFrom = 10e-6;        ///< [s]

double lagOf(const LawCandidate& candidate) {
    return candidate.fit.values[static_cast<Index>(candidate.model->find(UnknownKind::lag))];
}

/// The record as it was prepared, or with the distance of the file where that explains it (C5).
PreparedRecord arrivalChosen(PreparedRecord seen, const GaugeRecord& record,
                             const std::vector<GaugePlace>& places, const IdentifyQuestion& question,
                             std::size_t blow, const SizeTolerances& sizes, const std::stop_token& stop) {
    if (seen.shift == 0) return seen;
    Preparation other = prepareRecord(record, places, question, blow, ArrivalChoice::ofFile);
    if (other.refusal) return seen;
    RecordModel moved(seen, question, sizes, TrialLaw::bilinear);
    RecordModel kept(other.record, question, sizes, TrialLaw::bilinear);
    const LawFit movedFit = fitFromStarts(moved, stop), keptFit = fitFromStarts(kept, stop);
    const double movedRms = misfitOf(moved, movedFit, 1, 0).rms, keptRms = misfitOf(kept, keptFit, 1, 0).rms;
    const double lag = keptFit.values[static_cast<Index>(kept.find(UnknownKind::lag))];
    const double allowed = arrivalFrom + 2 * placeTolerance(question) / places.front().waveSpeed;
    const bool isNear = std::abs(lag) <= allowed && keptRms < 1.5 * movedRms;
    return isNear || keptRms < 0.8 * movedRms ? other.record : seen;
}

/// A record of two gauges with the transit time between them that fits best.
struct TransitTrial {
    /// With the transit time moved; nothing where there is little to explain, or where that explains little.
    std::optional<PreparedRecord> moved;
    ModelFit unmoved;  ///< of the record as it is
};

/// Moves the transit time between the gauges of a record by up to twice its tolerance.
TransitTrial tryTransits(const PreparedRecord& record, const IdentifyQuestion& question,
                         const SizeTolerances& sizes, const std::stop_token& stop) {
    constexpr double explained = 0.5;  // share of Σr² that a better distance removes at least
    constexpr int steps = 4;           // to either side, half a tolerance each
    constexpr double enough = 0.004;   // rms left over, share of the peak
    const GaugePlace& place = record.places.front();
    const double tolerance = std::hypot(placeTolerance(question) / place.waveSpeed,
                                        materialTolerance(question, place).tolerance * record.transit);
    TransitTrial trial;
    trial.unmoved.model = std::make_shared<RecordModel>(record, question, sizes, TrialLaw::bilinear);
    RecordModel& model = *trial.unmoved.model;
    trial.unmoved.fit = fitFromStarts(model, stop);
    const LawFit& unmoved = trial.unmoved.fit;
    if (misfitOf(model, unmoved, 1, 0).rms < enough) return trial;
    PreparedRecord best = record;
    Eigen::VectorXd bestValues = unmoved.values;
    double least = unmoved.cost;
    // Whether the fit with another transit time, from the best before it, is better.
    const auto isBetter = [&](double transit) {
        PreparedRecord moved = record;
        moved.transit = transit;
        RecordModel other(moved, question, sizes, TrialLaw::bilinear);
        Eigen::VectorXd values = bestValues;
        const double cost = fitAgain(other, model, values, stop);
        if (cost >= least) return false;
        least = cost;
        best = std::move(moved);
        bestValues = std::move(values);
        return true;
    };
    double size = tolerance / 2;
    for (const int way : {-1, 1})
        for (int step = 1; step <= steps && !stop.stop_requested(); ++step)
            if (!isBetter(record.transit + way * step * size)) break;
    for (int round = 0; round < 3 && !stop.stop_requested(); ++round) {
        size /= 2;
        const double middle = best.transit;
        if (!isBetter(middle - size)) isBetter(middle + size);
    }
    if (least <= (1 - explained) * unmoved.cost) trial.moved = std::move(best);
    return trial;
}

double autocorrelationOf(const RecordModel& model, const LawFit& fit) {
    double own = 0, next = 0;
    for (std::size_t i = 0; i + 1 < model.returningCount(); ++i) {
        const double a = fit.residuals[static_cast<Index>(i)], b = fit.residuals[static_cast<Index>(i + 1)];
        own += a * a;
        next += a * b;
    }
    return own > 0 ? next / own : 0;
}

void fillMatch(const LawTrials& trials, RecordAnswer& answer) {
    const LawCandidate& chosen = trials.chosen();
    const RecordModel& model = *chosen.model;
    const PreparedRecord& record = model.record();
    MatchFigures& match = answer.match;
    const MisfitFound& misfit = chosen.errors.misfit;
    match.misfit = misfit.misfit;
    match.noise = record.gauges.front().noise.deviation() / record.peak;
    match.expected = misfit.noise;
    match.ratio = misfit.ratio;
    match.autocorrelation = autocorrelationOf(model, chosen.fit);
    match.samples = model.returningCount();
    match.from = record.timeOf(model.firstReturning());
    match.to = record.timeOf(model.firstReturning() + model.returningCount() - 1);
    match.roundTripOfFile = record.roundTripToRock();
    match.roundTrip = match.roundTripOfFile + lagOf(chosen);
    answer.distanceThatFits += lagOf(chosen) * record.places.front().waveSpeed / 2;
    match.shiftOfSecond = record.secondShift;
    match.gainOfSecond = record.secondGain;
    match.quiet = chosen.errors.quiet;
    match.unexplained = chosen.errors.unexplained;
    match.before = record.before;
    match.bending = record.bending;
    match.isClipped = std::ranges::find(record.remarks, "clipped") != record.remarks.end();
    match.step = record.gauges.front().recorderStep / record.peak;
    const auto at = [&](const std::string& key) {
        return chosen.fit.values[static_cast<Index>(model.shapeUnknown(key))];
    };
    for (std::size_t g = 0; g < record.gauges.size(); ++g) {
        const std::string number = std::to_string(g + 1);
        match.zero.push_back({at("offset." + number), at("slope." + number)});
    }
    match.droop = at("droop");
    match.gainOfReturn = 1 + at("gain");
    if (model.hasDispersion()) {
        const auto share = static_cast<Index>(model.shapeUnknown("dispersion"));
        match.dispersion = chosen.fit.values[share];
        match.dispersionHalfWidth = chosen.errors.noise[share];
    }
    if (chosen.name == "jump") match.jumpTime = trials.jumpTime;
}

void fillCurves(RecordModel& model, const LawFit& fit, RecordAnswer& answer) {
    const PreparedRecord& record = model.record();
    const ChainModel& chain = model.solved(fit.values);
    MatchCurves& curves = answer.curves;
    const SeparatedWaves waves = separateWaves(record);
    const std::vector<double>& f = model.incidentNow();
    const double lag = fit.values[static_cast<Index>(model.find(UnknownKind::lag))];
    const auto on = [&](const std::vector<double>& grid, double time) {
        const double place = (time - model.gridStart()) / model.gridStep();
        const auto i = static_cast<std::size_t>(std::max(0.0, place));
        return place >= 0 && i + 1 < grid.size()
                   ? grid[i] + (place - static_cast<double>(i)) * (grid[i + 1] - grid[i])
                   : 0.0;
    };
    curves.front = record.startTime;
    curves.incidentEnd = record.startTime + record.incidentEnd;
    curves.quietFrom = record.startTime + record.quietFrom;
    const std::size_t last = model.firstReturning() + model.returningCount();
    for (std::size_t i = record.quiet; i < last; ++i) {
        const double t = record.timeOf(i), atRock = t - record.roundTrip - lag;
        curves.time.push_back(record.startTime + t);
        curves.incident.push_back(t < record.incidentEnd || record.isPair() ? on(f, t) : 0);
        const bool isReturning = i >= model.firstReturning();
        double measured = record.isPair() ? waves.returning[i] : record.gauges.front().force[i];
        double modelled = 0, residual = 0;
        if (isReturning) {
            const std::size_t k = i - model.firstReturning();
            modelled = model.modelReturning()[k];
            residual = fit.residuals[static_cast<Index>(k)] / (model.weight() * model.returningShare(k));
        }
        curves.measured.push_back(measured);
        curves.model.push_back(modelled);
        curves.residual.push_back(residual);
        const double incident = on(f, atRock);
        curves.modelForce.push_back(on(chain.rockForce(), atRock));
        curves.penetration.push_back(on(chain.penetration(), atRock));
        curves.force.push_back(isReturning ? incident + measured : 0);
    }
}

/// Half-widths at least as wide as the way to the answer with all sizes as in the file.
void checkSizes(const LawTrials& trials, const std::vector<KnownSize>& sizes, const std::stop_token& stop,
                std::vector<double>& atLeast, RecordAnswer& answer) {
    const LawCandidate& chosen = trials.chosen();
    const UsedUp used = usedUp(*chosen.model, chosen.fit);
    if (used.sizes <= tooFar) return;
    RecordModel held = *chosen.model;
    LawFit fit = chosen.fit;
    for (std::size_t u = 0; u < held.unknowns().size(); ++u) {
        const UnknownKind kind = held.unknowns()[u].kind;
        if (kind == UnknownKind::impedance || kind == UnknownKind::length ||
            kind == UnknownKind::sectionImpedance)
            fit.values[static_cast<Index>(u)] = 0;
    }
    held.holdSizes(true);
    refit(held, fit, stop);
    const UnknownKind kinds[] = {UnknownKind::stiffness, UnknownKind::gamma, UnknownKind::gap,
                                 UnknownKind::cornerForce, UnknownKind::cornerSlope};
    for (std::size_t i = 0; i < std::size(kinds); ++i) {
        const std::size_t u = held.find(kinds[i]);
        if (u < held.unknowns().size())
            atLeast[i] =
                std::abs(fit.values[static_cast<Index>(u)] - chosen.fit.values[static_cast<Index>(u)]);
    }
    const Unknown& size = chosen.model->unknowns()[used.size];
    const double change = chosen.fit.values[static_cast<Index>(used.size)];
    for (const KnownSize& known : sizes) {
        const bool isOfGauge = size.kind == UnknownKind::impedance;
        const bool isLength = size.kind == UnknownKind::length;
        if (known.isOfGauge != isOfGauge || (!isOfGauge && known.section != size.index)) continue;
        if ((known.impedance == 0) != isLength) continue;
        answer.sizeOff = SizeOff{known.key, isLength ? change : change / known.impedance * known.tolerance};
        break;
    }
    answer.remarks.emplace_back("sizes_off");
}

/// Whether the model had to leave its tolerances, and still leaves something (C7).
bool hasLeftTolerances(const UsedUp& used, const MisfitFound& misfit) {
    return misfit.misfit > usedUpMisfit && misfit.ratio > 1.3 &&
           std::max({used.zeroLines, used.droop, used.sizes}) > tooFar;
}

/// Whether the gain of the returning wave is far from that of the incident one and does not explain the
/// record: then something else is wrong, such as a second hit.
bool isGainDoubtful(const LawCandidate& chosen) {
    constexpr double farGain = 0.025, leastMisfit = 0.0015, leastRatio = 1.3;
    const double gain = chosen.fit.values[static_cast<Eigen::Index>(chosen.model->shapeUnknown("gain"))];
    const MisfitFound& misfit = chosen.errors.misfit;
    return std::abs(gain) > farGain && misfit.misfit > leastMisfit && misfit.ratio > leastRatio;
}

ModelVerdict verdictOf(const LawTrials& trials, RecordAnswer& answer, const IdentifyQuestion& question) {
    const LawCandidate& chosen = trials.chosen();
    const MisfitFound& misfit = chosen.errors.misfit;
    const PreparedRecord& record = chosen.model->record();
    ModelVerdict verdict = ModelVerdict::accepted;
    if (!isAccepted(misfit))
        verdict = misfit.misfit <= rejectedMisfit ? ModelVerdict::strained : ModelVerdict::rejected;
    const bool isRough = misfit.misfit > roughMisfit && misfit.ratio > roughRatio;
    if ((trials.isStrained || isRough) && verdict == ModelVerdict::accepted) verdict = ModelVerdict::strained;
    if (chosen.errors.unexplained > rejectedWave) verdict = ModelVerdict::rejected;
    if (const UsedUp used = usedUp(*chosen.model, chosen.fit); hasLeftTolerances(used, misfit)) {
        const bool isOfZero = used.sizes <= tooFar && misfit.misfit > strainedMisfit;
        if (!question.barBehind || !isOfZero) verdict = ModelVerdict::rejected;
    }
    const double lag = std::abs(lagOf(chosen) - record.shift);
    const double allowed =
        lagFrom + 4 * placeTolerance(question) / record.places.front().waveSpeed + record.roundTrip * 0.005;
    if (lag > allowed && misfit.misfit > strainedMisfit) {
        verdict = ModelVerdict::rejected;
        answer.remarks.emplace_back("arrival_off");
    } else if (lag > allowed && !answer.has("distance_off")) {
        answer.remarks.emplace_back("distance_off");
    }
    return verdict;
}

void addLaws(const LawTrials& trials, RecordAnswer& answer) {
    for (const LawCandidate& candidate : trials.candidates) {
        TriedLaw tried{candidate.name, candidate.misfit(), candidate.errors.misfit.ratio, {}};
        const auto add = [&](const char* key, UnknownKind kind, bool isLog) {
            const std::size_t u = candidate.model->find(kind);
            if (u >= candidate.model->unknowns().size()) return;
            const double value = candidate.fit.values[static_cast<Index>(u)];
            tried.parameters.emplace_back(key, isLog ? std::exp(value) : value);
        };
        add("bit_rock.stiffness", UnknownKind::stiffness, true);
        add("bit_rock.gamma", UnknownKind::gamma, true);
        add("bit_rock.gap", UnknownKind::gap, false);
        add("bit_rock.corner.1.force", UnknownKind::cornerForce, true);
        add("bit_rock.corner.1.slope", UnknownKind::cornerSlope, true);
        add("bit_rock.exponent", UnknownKind::exponent, false);
        add("dashpot", UnknownKind::dashpot, true);
        answer.laws.push_back(std::move(tried));
    }
}

/// The law of the file: timing and zero lines are fitted, and nothing else.
void checkFileLaw(const IdentifyQuestion& question, const GaugeRecord& given, const PreparedRecord& record,
                  const std::stop_token& stop, RecordAnswer& answer) {
    SizeTolerances none;
    auto model = std::make_shared<RecordModel>(record, question, none, TrialLaw::held);
    LawFit fit = fitFromStarts(*model, stop);
    LawTrials trials;
    trials.candidates.push_back({"file", model, std::move(fit), {}});
    LawCandidate& candidate = trials.candidates.front();
    candidate.errors = heldErrors(*model, candidate.fit, question.seed, stop);
    answer.model = verdictOf(trials, answer, question);
    answer.law = "file";
    fillMatch(trials, answer);
    fillCurves(*model, candidate.fit, answer);
    if (question.checkDistance)
        answer.check = blindCheck(given, *question.checkDistance, *model, candidate.fit);
    answer.laws.push_back({"file", candidate.misfit(), candidate.errors.misfit.ratio, {}});
}

/// Adds what these trials say to what is known of the record before.
RecordAnswer answerOf(RecordAnswer answer, const LawTrials& trials, const IdentifyQuestion& question,
                      const GaugeRecord& given, const std::vector<KnownSize>& sizes,
                      const std::stop_token& stop) {
    const LawCandidate& chosen = trials.chosen();
    answer.law = chosen.name == "corner" ? "corner" : "bilinear";
    for (const std::string& remark : chosen.errors.remarks) answer.remarks.push_back(remark);
    if (trials.candidates.size() > 1) answer.remarks.emplace_back("law_tried");
    if (trials.isLawOpen) answer.remarks.emplace_back("law_open");
    if (chosen.name == "crater") answer.remarks.emplace_back("crater");
    if (chosen.name == "jump") answer.remarks.emplace_back("zero_jumps");
    if (chosen.errors.unexplained > 0.01 && given.gauges.front().opposite.empty())
        answer.remarks.emplace_back("one_sided");
    if (chosen.model->hasDispersion() || question.dispersion == DispersionChoice::bar)
        answer.remarks.emplace_back("dispersion_corrected");
    for (const BudgetEffect& row : chosen.errors.budget)
        if (row.isAssumed) {
            answer.remarks.emplace_back("assumed_tolerances");
            break;
        }
    std::vector<double> atLeast(5, 0);
    checkSizes(trials, sizes, stop, atLeast, answer);
    // A specimen creeps and softens, which the zero lines take: its law is known to a factor only.
    if (question.barBehind && hasLeftTolerances(usedUp(*chosen.model, chosen.fit), chosen.errors.misfit))
        for (const std::size_t log : {0, 1, 3, 4}) atLeast[log] = std::max(atLeast[log], usedUpWidth);
    if (isGainDoubtful(chosen))
        for (const std::size_t log : {0, 1}) atLeast[log] = std::max(atLeast[log], doubtfulWidth);
    answer.model = verdictOf(trials, answer, question);
    fillMatch(trials, answer);
    fillCurves(*chosen.model, chosen.fit, answer);
    if (question.checkDistance)
        answer.check = blindCheck(given, *question.checkDistance, *chosen.model, chosen.fit);
    addLaws(trials, answer);
    fillParameters(trials, atLeast, answer);
    return answer;
}

/// Adds the answer by the law that fits to what is known of the record before. `known` is the fit of the
/// bilinear law, if there is one already.
RecordAnswer fittedAnswer(const RecordAnswer& before, const IdentifyQuestion& question,
                          const GaugeRecord& given, const PreparedRecord& record,
                          const std::vector<KnownSize>& sizes, ModelFit known, const std::stop_token& stop,
                          const ShowAnswer& showFirst) {
    const LawTrials trials =
        tryLaws(record, question, sizes, std::move(known), stop, [&](const LawTrials& first) {
            if (!showFirst) return;
            RecordAnswer shown = answerOf(before, first, question, given, sizes, stop);
            shown.isFirst = true;
            if (shown.model != ModelVerdict::rejected) showFirst(std::move(shown));
        });
    if (stop.stop_requested()) return before;
    RecordAnswer answer = answerOf(before, trials, question, given, sizes, stop);
    const IdentifiedParameter* gap = answer.find("bit_rock.gap");
    if (answer.model != ModelVerdict::rejected && gap && gap->low && gap->high && *gap->low > 0.02e-3 &&
        gapMayBeBend(trials, record, question, sizes, stop)) {
        answer.remarks.emplace_back("gap_or_bend");
        openGap(answer);
    }
    return answer;
}

}  // namespace

RecordAnswer identifyRecord(const IdentifyQuestion& question, const GaugeRecord& given,
                            const std::vector<GaugePlace>& places, std::size_t blow,
                            const std::stop_token& stop, const ShowAnswer& showFirst) {
    RecordAnswer answer;
    answer.file = given.file;
    answer.blow = blow;
    Preparation preparation = prepareRecord(given, places, question, blow);
    answer.refusal = preparation.refusal;
    if (answer.refusal) return answer;
    const std::vector<KnownSize> sizes = knownSizes(question, places.front());
    const SizeTolerances tolerances = sizeTolerances(sizes, places.front());
    const PreparedRecord record =
        arrivalChosen(std::move(preparation.record), given, places, question, blow, tolerances, stop);
    answer.remarks = record.remarks;
    answer.sign = record.sign;
    answer.peak = record.peak;
    answer.impedance = places.front().end.impedance;
    answer.distanceThatFits = given.gauges.front().distance;
    if (record.shift != 0) answer.remarks.emplace_back("distance_off");
    if (question.law == LawChoice::file) {
        checkFileLaw(question, given, record, stop, answer);
        return answer;
    }
    ModelFit known;
    if (record.isPair()) {
        TransitTrial trial = tryTransits(record, question, tolerances, stop);
        if (trial.moved) {
            RecordAnswer fitted =
                fittedAnswer(answer, question, given, *trial.moved, sizes, {}, stop, showFirst);
            if (fitted.model != ModelVerdict::rejected || stop.stop_requested()) return fitted;
        }
        known = std::move(trial.unmoved);
    }
    return fittedAnswer(answer, question, given, record, sizes, std::move(known), stop, showFirst);
}

}  // namespace drillwave
