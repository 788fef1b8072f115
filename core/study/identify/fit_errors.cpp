// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/identify/fit_errors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/study/identify/even_samples.h"
#include "core/study/identify/gauge_pair.h"

namespace drillwave {

namespace {

using Eigen::Index;

constexpr double misfitGaussian = 8e-6;  ///< −3 dB at 16.6 kHz [s]
constexpr double effectiveRate = 33e3;   ///< independent values per second below 16 kHz
constexpr double highestUnexplained = 16e3;
constexpr double lowestUnexplained = 300;
constexpr int unexplainedFrequencies = 18;
constexpr double shareOnIncident = 0.7;  ///< of an unexplained wave
constexpr double defaultGain = 0.02;
constexpr double speedOfSteel = 0.035;  ///< furthest from that of the file
constexpr double resolvedRise = 10e-6;  ///< a rise Z/k as short as that is lost in noise of 0.5 % [s]
constexpr double missedRise = 0.12;     ///< by so much, found with random stiff rocks (identify_scenes stiff)

/// Residuals of b below 16 kHz, in N.
std::vector<double> slowResiduals(const RecordModel& model, const Eigen::VectorXd& residuals) {
    std::vector<double> left(model.returningCount());
    for (std::size_t i = 0; i < left.size(); ++i) left[i] = residuals[static_cast<Index>(i)] / model.weight();
    smoothSamples(left, model.record().step, misfitGaussian);
    return left;
}

double rmsOf(const std::vector<double>& values) {
    double power = 0;
    for (const double value : values) power += value * value;
    return std::sqrt(power / static_cast<double>(std::max<std::size_t>(values.size(), 1)));
}

void finishMisfit(const RecordModel& model, const LawFit& fit, MisfitFound& found) {
    found.ratio = found.noise > 0 ? found.rms / found.noise : 0;
    const double excess = found.rms * found.rms - found.noise * found.noise;
    found.misfit = excess > 0 ? std::sqrt(excess) : 0;
    const double length = static_cast<double>(model.returningCount()) * model.record().step;
    const double independent = effectiveRate * length;
    std::size_t free = 3;
    for (const Unknown& unknown : model.unknowns()) free += unknown.isHeld || unknown.deviation > 0 ? 0 : 1;
    (void)fit;
    const double lost = static_cast<double>(free);
    const double factor =
        independent > lost ? std::min(2.0, std::sqrt(independent / (independent - lost))) : 2;
    const double noise = found.noise * (1 + found.scatter);
    const double beyond = found.rms * found.rms - noise * noise;
    found.unexplained = beyond > 0 ? std::sqrt(2 * beyond) * factor : 0;
}

/// One change of the record and what it does to the residuals of b and of the quiet stretch.
class Perturbation {
  public:
    Perturbation(RecordModel& model, const LawFit& fit) : m_model(model), m_fit(fit) {}
    Eigen::VectorXd change(const SeparatedWaves& waves, const std::vector<double>& quiet) {
        m_model.changedResiduals(m_fit.values, waves, quiet, m_result);
        return m_result - m_fit.residuals;
    }

  private:
    RecordModel& m_model;
    const LawFit& m_fit;
    Eigen::VectorXd m_result;
};

std::vector<double> quietPart(const RecordModel& model, const std::vector<double>& signal) {
    const auto first = signal.begin() + static_cast<std::ptrdiff_t>(model.firstQuiet());
    return model.quietCount()
               ? std::vector<double>(first, first + static_cast<std::ptrdiff_t>(model.quietCount()))
               : std::vector<double>();
}

void drawNoise(RecordModel& model, const LawFit& fit, std::uint64_t seed, const std::stop_token& stop,
               FitErrors& errors) {
    const PreparedRecord& record = model.record();
    std::mt19937_64 random(seed);
    Perturbation perturbation(model, fit);
    const std::size_t gap = model.find(Unknown::Kind::gap);
    errors.gap = static_cast<Index>(gap);
    errors.draws.setZero(fit.values.size(), noiseDraws);
    double sum = 0, squares = 0;
    for (int draw = 0; draw < noiseDraws && !stop.stop_requested(); ++draw) {
        std::vector<std::vector<double>> noises;
        std::vector<const std::vector<double>*> signals;
        for (const PreparedGauge& gauge : record.gauges)
            noises.push_back(gauge.noise.draw(record.count(), record.quiet, random));
        for (const std::vector<double>& noise : noises) signals.push_back(&noise);
        const SeparatedWaves waves = separateWaves(record, signals, record.transit);
        Eigen::VectorXd change = perturbation.change(waves, quietPart(model, noises.front()));
        for (std::size_t u = 0; u < model.unknowns().size(); ++u)
            if (model.unknowns()[u].kind == Unknown::Kind::shape)
                change[static_cast<Index>(model.priorRow(u))] -= standardNormal(random);
        Eigen::VectorXd moved = fit.movedBy(change);
        if (gap < fit.unknownCount() &&
            fit.values[static_cast<Index>(gap)] + moved[static_cast<Index>(gap)] < 0) {
            moved = fit.movedWithoutGap(change);
            moved[static_cast<Index>(gap)] = -fit.values[static_cast<Index>(gap)];
        }
        errors.draws.col(draw) = moved;
        const double rms = rmsOf(slowResiduals(model, fit.left(change, moved))) / record.peak;
        sum += rms;
        squares += rms * rms;
    }
    const double mean = sum / noiseDraws;
    errors.misfit.noise = mean;
    errors.misfit.scatter =
        mean > 0 ? std::sqrt(std::max(0.0, squares / noiseDraws - mean * mean)) / mean : 0;
    errors.noise = half95 * (errors.draws.array().square().rowwise().sum() / noiseDraws).sqrt().matrix();
}

void addSizes(const RecordModel& model, const LawFit& fit, const std::vector<KnownSize>& sizes,
              FitErrors& errors) {
    using Kind = Unknown::Kind;
    const Index stiffness = static_cast<Index>(model.find(Kind::stiffness));
    double total[2] = {0, 0};  // of the gauge's section
    for (const KnownSize& size : sizes)
        if (size.isOfGauge) total[0] = std::hypot(total[0], size.impedance);
    std::vector<double> ofSection(model.record().places.front().towardsBit.size(), 0);
    for (const KnownSize& size : sizes)
        if (!size.isOfGauge) ofSection[size.section] = std::hypot(ofSection[size.section], size.impedance);
    for (const KnownSize& size : sizes) {
        const std::string field = size.key.substr(size.key.rfind('.') + 1);
        BudgetEffect row{field, size.key, size.tolerance, size.unit, size.isAssumed, {}};
        const Kind kind = size.isOfGauge       ? Kind::impedance
                          : size.impedance > 0 ? Kind::sectionImpedance
                                               : Kind::length;
        const std::size_t unknown = model.find(kind, size.isOfGauge ? 0 : size.section);
        if (unknown < model.unknowns().size()) {
            const double part = size.isOfGauge       ? size.impedance / total[0]
                                : size.impedance > 0 ? size.impedance / ofSection[size.section]
                                                     : 1;
            row.effect = fit.movedByPrior(model, unknown) * part;
        } else if (size.isOfGauge) {
            row.effect = Eigen::VectorXd::Zero(fit.values.size());
            row.effect[stiffness] =
                size.impedance;  // k is proportional to Z, and the record does not tell it
            const std::size_t corner = model.find(Kind::cornerForce);
            if (corner < model.unknowns().size()) row.effect[static_cast<Index>(corner)] = size.impedance;
        } else {
            continue;
        }
        errors.budget.push_back(std::move(row));
    }
}

void addAssumptions(RecordModel& model, const LawFit& fit, const IdentifyQuestion& question,
                    FitErrors& errors) {
    using Kind = Unknown::Kind;
    const PreparedRecord& record = model.record();
    const GaugePlace& place = record.places.front();
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(fit.values.size());
    const Index stiffness = static_cast<Index>(model.find(Kind::stiffness));

    const KnownSize material = materialTolerance(question, place);
    BudgetEffect row{"material", "material", material.tolerance, "1", material.isAssumed, none};
    row.effect[stiffness] = material.tolerance;
    errors.budget.push_back(row);

    double gain = defaultGain;
    bool isAssumed = true;
    for (const KnownTolerance& known : question.known)
        if (known.key == "gain") gain = known.tolerance, isAssumed = false;
    row = {"gain", "gain", gain, "1", isAssumed, none};
    const std::size_t gap = model.find(Kind::gap), corner = model.find(Kind::cornerForce);
    row.effect[static_cast<Index>(gap)] = gain * fit.values[static_cast<Index>(gap)];
    if (corner < model.unknowns().size()) row.effect[static_cast<Index>(corner)] = gain;
    errors.budget.push_back(row);

    // Noise of f drives a law with memory: steep rocks have false minima in it, which no linearisation sees.
    const double stiffnessTime = place.end.impedance / std::exp(fit.values[stiffness]);
    const double noise = std::min(1.5, record.gauges.front().noise.deviation() / record.peak / 0.005);
    const double steepness = std::min(3.0, resolvedRise / stiffnessTime);
    row = {"resolution", "", resolvedRise, "s", false, none};
    row.effect[stiffness] = missedRise * steepness * noise;
    row.effect[static_cast<Index>(model.find(Kind::gamma))] = missedRise * steepness * noise;
    row.effect[static_cast<Index>(gap)] =
        0.5 * missedRise * steepness * noise * fit.values[static_cast<Index>(gap)];
    errors.budget.push_back(row);

    const double tolerance = placeTolerance(question), speed = place.waveSpeed;
    const double lag = fit.values[static_cast<Index>(model.find(Kind::lag))];
    const double allowed = 4 * tolerance / speed + record.roundTrip * 0.005;
    // Another distance than in the file may as well be another wave speed, as far as steels differ.
    const double ofPlace = std::max(0.0, std::abs(lag) - allowed) / record.roundTrip;
    const double late = record.shift == 0 ? ofPlace : std::min(ofPlace, speedOfSteel);
    if (late > 0) {
        row = {"timing", "gauge", late, "1", false, none};
        row.effect[stiffness] = std::sqrt(2.0) * late;
        errors.budget.push_back(row);
    }

    Perturbation perturbation(model, fit);
    std::vector<const std::vector<double>*> signals;
    for (const PreparedGauge& gauge : record.gauges) signals.push_back(&gauge.force);
    if (record.isPair()) {
        const double change = std::sqrt(2.0) * tolerance / speed;
        const SeparatedWaves base = separateWaves(record);
        SeparatedWaves moved = separateWaves(record, signals, record.transit + change);
        for (std::size_t i = 0; i < moved.incident.size(); ++i) {
            moved.incident[i] -= base.incident[i];
            moved.returning[i] -= base.returning[i];
        }
        bool isTold = false;
        for (const KnownTolerance& known : question.known) isTold = isTold || known.key == "gauge";
        row = {"place", "gauge", tolerance, "m", !isTold, none};
        row.effect = fit.movedBy(perturbation.change(moved, {}));
        errors.budget.push_back(row);
    }
    const PreparedGauge& near = record.gauges.front();
    if (near.noise.deviation() < near.recorderStep / 2) {
        const double half = near.recorderStep / 2;
        SeparatedWaves onIncident, onReturning;
        onIncident.incident.assign(record.count(), 0);
        onIncident.returning.assign(record.count(), 0);
        onReturning = onIncident;
        for (std::size_t i = record.front; i < record.count(); ++i) {
            const double t = record.timeOf(i);
            if (std::abs(near.force[i]) > 0.15 * record.peak && t < record.incidentEnd)
                onIncident.incident[i] = half;
            onReturning.returning[i] = half;
        }
        row = {"step", "", near.recorderStep, "N", false, none};
        const Eigen::VectorXd one = fit.movedBy(perturbation.change(onIncident, {}));
        const Eigen::VectorXd other = fit.movedBy(perturbation.change(onReturning, {}));
        row.effect = (one.array().square() + other.array().square()).sqrt().matrix();
        errors.budget.push_back(row);
    }
}

/// rms of the quiet stretch about a straight line of its own, noise off [N].
double aboutOwnLine(const RecordModel& model, const LawFit& fit) {
    const std::vector<double> left = quietLeft(model, fit.values);
    const auto n = static_cast<double>(left.size());
    double mean = 0, moment = 0, spread = 0, power = 0;
    for (std::size_t i = 0; i < left.size(); ++i) {
        const double x = static_cast<double>(i) - (n - 1) / 2;
        mean += left[i] / n;
        moment += x * left[i];
        spread += x * x;
    }
    for (std::size_t i = 0; i < left.size(); ++i) {
        const double x = static_cast<double>(i) - (n - 1) / 2;
        power += std::pow(left[i] - mean - (spread > 0 ? moment / spread * x : 0), 2) / n;
    }
    const PreparedRecord& record = model.record();
    const double noise = record.gauges.front().noise.deviationOfMean(
        std::max<std::size_t>(1, static_cast<std::size_t>(71e-6 / record.step)));
    return std::sqrt(std::max(0.0, power - noise * noise));
}

/// Waves in the quiet stretch: what they move, and how large an unexplained wave they are.
void addQuiet(const RecordModel& model, const LawFit& fit, FitErrors& errors) {
    const PreparedRecord& record = model.record();
    const QuietErrors found = quietErrors(model, fit.values);
    const double floor = quietFloor * record.peak;
    // the tail, 100 µs by 100 µs
    const auto span = static_cast<std::size_t>(100e-6 / record.step);
    BudgetEffect row{"tail", "", 0, "1", false, Eigen::VectorXd::Zero(fit.values.size())};
    Eigen::VectorXd squares = row.effect;
    for (std::size_t from = 0; from < model.quietCount(); from += span) {
        Eigen::VectorXd change = Eigen::VectorXd::Zero(fit.residuals.size());
        for (std::size_t i = from; i < std::min(from + span, model.quietCount()); ++i) {
            const bool isLast = record.timeOf(model.firstQuiet() + i) >= record.incidentEnd - 120e-6;
            change[static_cast<Index>(model.returningCount() + i)] =
                std::max(floor, isLast ? found.last : found.before) * model.quietWeight(i);
        }
        squares += fit.movedBy(change).cwiseAbs2();
    }
    row.tolerance = std::max(floor, found.last) / record.peak;
    row.effect = half95 * squares.cwiseSqrt();
    errors.budget.push_back(row);

    double wave = std::sqrt(2.0) * found.last / record.peak;
    bool isFading = false;
    if (found.hasBefore && found.before > 0) {
        const double fading = found.last / found.before;
        isFading = fading <= 0.5;
        wave *= std::min(1.0, std::max(0.3, fading));
    }
    if (!isFading) {
        // A wave that stays: its power over all of the stretch. A zero line through the stretch takes half of
        // it.
        const double pooled =
            found.hasBefore ? std::hypot(found.last, found.before) / std::sqrt(2.0) : found.last;
        wave =
            std::max(std::sqrt(2.0) * std::max(std::min(pooled, found.last), 1.4 * aboutOwnLine(model, fit)) /
                         record.peak,
                     wave);
    }
    const std::vector<double> left = quietLeft(model, fit.values);
    double power = 0;
    std::size_t count = 0;
    for (std::size_t i = left.size() * 2 / 5; i < left.size(); ++i, ++count)
        if (left[i] < -floor) power += left[i] * left[i];
    const double noise = record.gauges.front().noise.deviationOfMean(
        std::max<std::size_t>(1, static_cast<std::size_t>(71e-6 / record.step)));
    const double negative =
        count ? std::sqrt(std::max(0.0, power / static_cast<double>(count) - noise * noise)) : 0;
    const double below = 2 * negative / record.peak;
    errors.quiet = std::max(found.last, negative) / record.peak;
    errors.unexplained = std::max(wave, below);
    errors.isTail = isFading && wave >= below;
}

void addUnexplained(RecordModel& model, const LawFit& fit, const std::stop_token& stop, FitErrors& errors) {
    const PreparedRecord& record = model.record();
    errors.unexplainedEffect = Eigen::VectorXd::Zero(fit.values.size());
    if (errors.unexplained <= 0) return;
    const double begin = record.timeOf(model.firstReturning());
    const double lowest = std::max(lowestUnexplained, 0.5 / (record.end - begin));
    Perturbation perturbation(model, fit);
    const double amplitude = errors.unexplained * record.peak;
    for (int i = 0; i < unexplainedFrequencies && !stop.stop_requested(); ++i) {
        const double frequency =
            lowest * std::pow(highestUnexplained / lowest, i / (unexplainedFrequencies - 1.0));
        Eigen::VectorXd squares = Eigen::VectorXd::Zero(fit.values.size());
        for (const bool isOnIncident : {false, true}) {
            if (isOnIncident && errors.isTail) continue;
            for (const double phase : {0.0, 0.25}) {
                SeparatedWaves waves;
                waves.incident.assign(record.count(), 0);
                waves.returning.assign(record.count(), 0);
                for (std::size_t k = record.front; k < record.count(); ++k) {
                    const double t = record.timeOf(k);
                    const double value = amplitude * std::sin(2 * std::numbers::pi * (frequency * t + phase));
                    if (!isOnIncident)
                        waves.returning[k] = value;
                    else if (t < record.incidentEnd || record.isPair())
                        waves.incident[k] = shareOnIncident * value;
                }
                squares += fit.movedBy(perturbation.change(waves, {})).cwiseAbs2();
            }
        }
        errors.unexplainedEffect = errors.unexplainedEffect.cwiseMax(squares.cwiseSqrt());
    }
}

}  // namespace

Eigen::VectorXd FitErrors::halfWidths() const {
    constexpr double ofOneLine = 0.003, ofCorner = 0.02;  // recorders round corners off
    constexpr double gapOfCells = 5e-6;
    const double ofCells = hasCorner ? ofCorner : ofOneLine;
    Eigen::VectorXd squares = noise.cwiseAbs2() * std::max(1.0, misfit.ratio * misfit.ratio);
    for (const BudgetEffect& row : budget) squares += row.effect.cwiseAbs2();
    squares += unexplainedEffect.cwiseAbs2();
    for (Index i = 0; i < squares.size(); ++i)
        squares[i] += std::pow(i == gap ? std::hypot(gapOfCells, gapOfSample) : ofCells, 2);
    return squares.cwiseSqrt();
}

MisfitFound misfitOf(const RecordModel& model, const LawFit& fit, double noise, double scatter) {
    MisfitFound found;
    found.noise = noise;
    found.scatter = scatter;
    found.rms = rmsOf(slowResiduals(model, fit.residuals)) / model.record().peak;
    finishMisfit(model, fit, found);
    return found;
}

UsedUp usedUp(const RecordModel& model, const LawFit& fit) {
    UsedUp used;
    for (std::size_t u = 0; u < model.unknowns().size(); ++u) {
        const Unknown& unknown = model.unknowns()[u];
        if (unknown.deviation <= 0 || unknown.isHeld) continue;
        const double share =
            std::abs(fit.values[static_cast<Index>(u)] - unknown.mean) / (half95 * unknown.deviation);
        if (unknown.kind == Unknown::Kind::shape) {
            const std::string& key = model.shapes()[unknown.index].key;
            if (key == "droop") used.droop = std::max(used.droop, share);
            if (key.starts_with("offset") || key.starts_with("slope"))
                used.zeroLines = std::max(used.zeroLines, share);
        } else if (share > used.sizes) {
            used.sizes = share;
            used.size = u;
        }
    }
    return used;
}

FitErrors heldErrors(RecordModel& model, const LawFit& fit, std::uint64_t seed, const std::stop_token& stop) {
    FitErrors errors;
    drawNoise(model, fit, seed, stop, errors);
    errors.misfit = misfitOf(model, fit, errors.misfit.noise, errors.misfit.scatter);
    if (model.quietCount() > 0)
        addQuiet(model, fit, errors);
    else if (model.record().isPair())
        errors.quiet = passageDifference(model.record());
    errors.unexplained = std::max(errors.unexplained, errors.misfit.unexplained);
    return errors;
}

FitErrors fitErrors(RecordModel& model, const LawFit& fit, const IdentifyQuestion& question,
                    const std::vector<KnownSize>& sizes, std::uint64_t seed, const std::stop_token& stop) {
    FitErrors errors;
    const PreparedRecord& record = model.record();
    errors.hasCorner = model.law() == TrialLaw::corner;
    errors.gapOfSample = record.step * record.peak / record.places.front().end.impedance;
    drawNoise(model, fit, seed, stop, errors);
    errors.misfit = misfitOf(model, fit, errors.misfit.noise, errors.misfit.scatter);
    addSizes(model, fit, sizes, errors);
    addAssumptions(model, fit, question, errors);
    if (model.quietCount() > 0)
        addQuiet(model, fit, errors);
    else if (record.isPair()) {
        errors.quiet = passageDifference(record);
        errors.unexplained = std::sqrt(2.0) * errors.quiet;
    }
    const auto raise = [&](double share) {
        if (share <= errors.unexplained) return;
        errors.unexplained = share;
        errors.isTail = false;
    };
    raise(errors.misfit.unexplained);
    raise(2 * record.before);
    for (std::size_t u = 0; u < model.unknowns().size(); ++u) {
        const Unknown& unknown = model.unknowns()[u];
        if (unknown.kind != Unknown::Kind::shape) continue;
        const LinearShape& shape = model.shapes()[unknown.index];
        if (!shape.key.starts_with("offset") && !shape.key.starts_with("slope") && shape.key != "droop")
            continue;
        const double amount = std::abs(fit.values[static_cast<Index>(u)]);
        if (amount <= 1.1 * shape.tolerance) continue;
        if (errors.remarks.empty()) errors.remarks.emplace_back("zero_line");
        // Without a step at the tolerance; twice that is believed in full.
        raise(std::min(amount, 2 * (amount - shape.tolerance)) * rmsOf(shape.returning) / record.peak);
    }
    if (errors.unexplained > 0.01) errors.remarks.emplace_back("unexplained_wave");
    addUnexplained(model, fit, stop, errors);
    return errors;
}

}  // namespace drillwave
