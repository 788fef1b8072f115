// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/identify/law_search.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace drillwave {

namespace {

using Eigen::Index;

constexpr double asGood = 1.05;      ///< of Σr² of the returning wave
constexpr double clearlyLess = 0.7;  ///< of what is unexplained
constexpr double largeShare = 0.3;   ///< of the tolerance of a zero line: others are tried

/// van der Corput's sequence: evenly filled, the same on every machine.
double evenShare(unsigned index, unsigned base) {
    double share = 0, part = 1;
    for (; index > 0; index /= base) {
        part /= base;
        share += part * (index % base);
    }
    return share;
}

struct Start {
    Eigen::VectorXd values;
    double cost = 0;
    int group = 0;  ///< of starts that are alike; 0: like no other
};

void scoreAndSort(RecordModel& model, std::vector<Start>& starts, const std::stop_token& stop) {
    Eigen::VectorXd residuals;
    for (Start& start : starts) {
        if (stop.stop_requested()) return;
        clampToBounds(model, start.values);
        model.residuals(start.values, residuals);
        start.cost = residuals.squaredNorm();
    }
    std::stable_sort(starts.begin(), starts.end(),
                     [](const Start& a, const Start& b) { return a.cost < b.cost; });
}

/// The best of searches from the best start of each group, from at most so many.
Start bestOf(RecordModel& model, std::vector<Start> starts, std::size_t most, const std::stop_token& stop) {
    scoreAndSort(model, starts, stop);
    std::vector<int> groups;
    std::erase_if(starts, [&](const Start& start) {
        const bool isLater = start.group > 0 && std::ranges::find(groups, start.group) != groups.end();
        groups.push_back(start.group);
        return isLater;
    });
    starts.resize(std::min(starts.size(), most));
    for (Start& start : starts) start.cost = minimise(model, start.values, 25, stop);
    return *std::min_element(starts.begin(), starts.end(),
                             [](const Start& a, const Start& b) { return a.cost < b.cost; });
}

std::vector<Start> evenStarts(const RecordModel& model, unsigned from, unsigned count) {
    using Kind = Unknown::Kind;
    std::vector<Start> starts;
    const Eigen::VectorXd base = startValues(model);
    if (model.law() == TrialLaw::held) return {{base, 0}};
    const double middle = std::log(model.record().places.front().end.impedance / 200e-6);
    for (unsigned i = from; i < from + count; ++i) {
        Start start{base, 0};
        const auto set = [&](Kind kind, double value) {
            start.values[static_cast<Index>(model.find(kind))] = value;
        };
        set(Kind::stiffness, middle + (evenShare(i + 1, 2) - 0.5) * 4 * std::log(10.0));
        set(Kind::gamma, std::log(0.03) * evenShare(i + 1, 3));
        set(Kind::gap, std::pow(evenShare(i + 1, 5), 3) * 2e-3 * model.record().gapScale);
        starts.push_back(std::move(start));
    }
    return starts;
}

/// Moves the line of dispersion to `share`; its unknown is the last one then.
void takeDispersion(RecordModel& model, Eigen::VectorXd& values, double share, bool isFree) {
    const std::size_t there = model.shapeUnknown("dispersion");
    if (there < model.unknowns().size()) {
        Eigen::VectorXd kept(values.size() - 1);
        for (Index i = 0, k = 0; i < values.size(); ++i)
            if (i != static_cast<Index>(there)) kept[k++] = values[i];
        values = kept;
    }
    model.setDispersion(share, isFree);
    if (model.hasDispersion()) {
        values.conservativeResize(values.size() + 1);
        values[values.size() - 1] = share;
    }
}

/// Moves a held share of dispersion by ± `step`, which is halved after each round, while that lowers Σr². It
/// has false minima 0.01 apart together with the lag, which a linearised share does not leave.
void searchShare(RecordModel& model, Start& best, double& share, double step, int rounds,
                 const std::stop_token& stop) {
    constexpr double leastShare = -0.1, largestShare = 1.2;
    for (int round = 0; round < rounds && !stop.stop_requested(); ++round, step /= 2) {
        const double middle = share;
        for (const double other : {middle - step, middle + step}) {
            if (other < leastShare || other > largestShare) continue;
            model.setDispersion(other, false);
            Start found = best;
            found.cost = minimise(model, found.values, 25, stop);
            if (found.cost >= best.cost) continue;
            best = std::move(found);
            share = other;
        }
    }
    model.setDispersion(share, false);
}

/// Takes over the dispersion of a solution of another model: its share, which stays free if it is free there.
void takeDispersionOf(RecordModel& model, const RecordModel& other, const Eigen::VectorXd& values) {
    model.setDispersion(other.dispersionShare(values), other.hasDispersion());
}

void followDispersion(RecordModel& model, Eigen::VectorXd& values, const std::stop_token& stop) {
    for (int round = 0; round < 5 && model.hasDispersion() && !stop.stop_requested(); ++round) {
        const double share = model.dispersionShare(values);
        takeDispersion(model, values, share, true);
        minimise(model, values, 40, stop);
        if (std::abs(model.dispersionShare(values) - share) < 0.005) break;
    }
}

/// Fits again until the weights of the quiet stretch move by less than 15 %.
void followQuiet(RecordModel& model, Eigen::VectorXd& values, const std::stop_token& stop) {
    if (model.quietCount() == 0) return;
    const double floor = quietFloor * model.record().peak;
    double before = floor, last = floor;
    for (int round = 0; round < 5 && !stop.stop_requested(); ++round) {
        const QuietErrors errors = quietErrors(model, values);
        const double nextBefore = std::max(errors.before, floor), nextLast = std::max(errors.last, floor);
        if (std::abs(nextBefore / before - 1) < 0.15 && std::abs(nextLast / last - 1) < 0.15) break;
        before = nextBefore;
        last = nextLast;
        model.setQuietErrors(before, last);
        minimise(model, values, 40, stop);
    }
}

/// Starts of a law about the solution of the bilinear one.
std::vector<Start> startsFrom(const RecordModel& model, RecordModel& bilinear, const LawFit& from) {
    using Kind = Unknown::Kind;
    Eigen::VectorXd base = startValues(model);
    for (std::size_t j = 0; j < model.unknowns().size(); ++j) {
        const Unknown& unknown = model.unknowns()[j];
        const std::size_t same = unknown.kind == Kind::shape
                                     ? bilinear.shapeUnknown(model.shapes()[unknown.index].key)
                                     : bilinear.find(unknown.kind, unknown.index);
        // A law that does not fit has bent the zero lines: others begin without.
        const bool isZeroLine = unknown.kind == Kind::shape && model.law() != TrialLaw::bilinear;
        if (same < bilinear.unknowns().size() && !isZeroLine)
            base[static_cast<Index>(j)] = from.values[static_cast<Index>(same)];
    }
    std::vector<Start> starts;
    const auto set = [&](Start& start, Kind kind, double value) {
        start.values[static_cast<Index>(model.find(kind))] = value;
    };
    const auto get = [&](Kind kind) { return base[static_cast<Index>(model.find(kind))]; };
    const double peak = model.record().peak;
    if (model.law() == TrialLaw::corner) {
        // A corner that the force hardly reaches fits as well as the bilinear law and leads nowhere: each
        // place and sense of the corner has a search of its own.
        const double largest = std::max(largestForce(bilinear, from), 0.1 * peak);
        for (const double force : {0.15, 0.35, 0.55, 0.75, 0.9})
            for (const double slope : {0.2, 0.45, 0.75, 1.6, 3.5})
                for (const double softer : {1.0, 1.4, 2.0, 3.0}) {
                    if (slope > 1 && softer > 1.8) continue;
                    const int group = 1 + 2 * static_cast<int>(10 * force) + (slope > 1 ? 1 : 0);
                    Start start{base, 0, group};
                    set(start, Kind::cornerForce, std::log(force * largest));
                    set(start, Kind::cornerSlope, std::log(slope));
                    set(start, Kind::stiffness,
                        get(Kind::stiffness) + (slope < 1 ? 1 : -1) * std::log(softer));
                    starts.push_back(start);
                    set(start, Kind::gap, 0);
                    starts.push_back(std::move(start));
                }
    } else if (model.law() == TrialLaw::power) {
        for (const double exponent : {0.6, 0.85, 1.2, 1.5, 2.0})
            for (const double gap : {0.0, 1.0}) {
                Start start{base, 0};
                set(start, Kind::exponent, exponent);
                set(start, Kind::gap, gap * get(Kind::gap));
                starts.push_back(std::move(start));
            }
    } else if (model.law() == TrialLaw::crater) {
        for (const double part : {0.05, 0.2, 0.5})
            for (const double harder : {0.0, -0.5, 0.5}) {
                Start start{base, 0};
                set(start, Kind::memory, part * peak);
                set(start, Kind::stiffness, get(Kind::stiffness) + harder);
                set(start, Kind::gap, 0);
                starts.push_back(std::move(start));
            }
    } else if (model.law() == TrialLaw::dashpot) {
        const double impedance = model.record().places.front().end.impedance;
        for (const double part : {0.01, 0.06, 0.3}) {
            Start start{base, 0};
            set(start, Kind::dashpot, std::log(part * impedance));
            starts.push_back(std::move(start));
        }
    } else {
        starts.push_back({base, 0});
    }
    return starts;
}

/// Holds all disturbances but dispersion and returns their unknowns: zero lines, droop, gain and bending.
std::vector<std::size_t> holdZeroLines(RecordModel& model) {
    std::vector<std::size_t> held;
    for (std::size_t u = 0; u < model.unknowns().size(); ++u) {
        Unknown& unknown = model.unknowns()[u];
        if (unknown.kind != Unknown::Kind::shape || unknown.isHeld || unknown.deviation <= 0) continue;
        if (model.shapes()[unknown.index].key == "dispersion") continue;
        unknown.isHeld = true;
        held.push_back(u);
    }
    return held;
}

LawFit finished(RecordModel& model, Eigen::VectorXd values) {
    LawFit fit;
    fit.law = model.law();
    fit.values = std::move(values);
    fit.linearise(model);
    return fit;
}

/// Returns the largest part of the record [peak] that a fit leaves between blow and reflection, or takes by
/// zero lines beyond their tolerance.
double unexplainedShare(const RecordModel& model, const Eigen::VectorXd& values) {
    double share = std::sqrt(2.0) * quietErrors(model, values).last / model.record().peak;
    for (std::size_t u = 0; u < model.unknowns().size(); ++u) {
        const Unknown& unknown = model.unknowns()[u];
        if (unknown.kind != Unknown::Kind::shape || unknown.deviation <= 0) continue;
        const double tolerance = half95 * unknown.deviation;
        const double beyond = std::abs(values[static_cast<Index>(u)] - unknown.mean) - tolerance;
        if (model.shapes()[unknown.index].key.starts_with("offset")) share = std::max(share, 2 * beyond);
    }
    return share;
}

/// Searches again with zero lines, droop and gain of the return at their expected values, and frees them at
/// the end, if one of them is large: together they can lead a search into a minimum of their own.
void searchWithoutZeroLines(RecordModel& model, LawFit& fit, const std::stop_token& stop) {
    Eigen::VectorXd values = fit.values;
    const std::vector<std::size_t> held = holdZeroLines(model);
    bool isFar = false;
    for (const std::size_t u : held) {
        const Unknown& unknown = model.unknowns()[u];
        double& value = values[static_cast<Index>(u)];
        isFar = isFar || std::abs(value - unknown.mean) > largeShare * half95 * unknown.deviation;
        value = unknown.mean;
    }
    const auto free = [&] {
        for (const std::size_t u : held) model.unknowns()[u].isHeld = false;
    };
    if (!isFar) return free();
    // Weights that have followed the zero lines would let them go again.
    const double floor = quietFloor * model.record().peak;
    model.setQuietErrors(floor, floor);
    minimise(model, values, 40, stop);
    free();
    minimise(model, values, 60, stop);
    followQuiet(model, values, stop);
    LawFit found = finished(model, values);
    const auto returned = static_cast<Index>(model.returningCount());
    const double before = fit.residuals.head(returned).squaredNorm();
    if (found.residuals.head(returned).squaredNorm() < asGood * before &&
        unexplainedShare(model, values) < clearlyLess * unexplainedShare(model, fit.values)) {
        fit = std::move(found);
        return;
    }
    const QuietErrors errors = quietErrors(model, fit.values);
    model.setQuietErrors(std::max(errors.before, floor), std::max(errors.last, floor));
    fit.linearise(model);
}

/// Frees a share of dispersion, if there is one, and the sizes of sections, and fits from values found with
/// both held.
LawFit fitFromShare(RecordModel& model, Eigen::VectorXd best, std::optional<double> share,
                    const std::stop_token& stop) {
    if (model.law() != TrialLaw::held && !stop.stop_requested()) {
        Eigen::VectorXd closed = best;
        closed[static_cast<Index>(model.find(Unknown::Kind::gap))] = 0;
        const double cost = minimise(model, best, 40, stop);
        if (minimise(model, closed, 40, stop) < cost) best = closed;
    }
    if (share) {
        takeDispersion(model, best, *share, true);
        minimise(model, best, 40, stop);
        followDispersion(model, best, stop);
    }
    model.holdSizes(false);
    minimise(model, best, 60, stop);
    followQuiet(model, best, stop);
    followDispersion(model, best, stop);
    LawFit fit = finished(model, best);
    searchWithoutZeroLines(model, fit, stop);
    return fit;
}

}  // namespace

double largestForce(RecordModel& model, const LawFit& fit) {
    const std::vector<double>& force = model.solved(fit.values).rockForce();
    return force.empty() ? 0 : *std::ranges::max_element(force);
}

LawFit fitFromStarts(RecordModel& model, const std::stop_token& stop) {
    constexpr double clearlyBetter = 0.95;  // ratio of Σr²: two minima closer than that differ by noise only
    model.holdSizes(true);
    const double floor = quietFloor * model.record().peak;
    model.setQuietErrors(floor, floor);
    model.setDispersion(0.5, true);
    if (model.dispersionChoice() != DispersionChoice::fit || !model.hasDispersion()) {
        model.setDispersion(model.heldShare(), false);
        return fitFromShare(model, bestOf(model, evenStarts(model, 0, 120), 4, stop).values, {}, stop);
    }
    Start best;
    double share = 0;
    for (int k = 0; k < 3; ++k) {
        model.setDispersion(0.5 * k, false);
        Start found = bestOf(model, evenStarts(model, static_cast<unsigned>(40 * k), 60), 3, stop);
        if (best.values.size() > 0 && found.cost >= best.cost) continue;
        best = std::move(found);
        share = 0.5 * k;
    }
    searchShare(model, best, share, 0.25, 1, stop);
    RecordModel finer = model;
    const double coarse = share;
    LawFit fit = fitFromShare(model, best.values, share, stop);
    searchShare(finer, best, share, 0.125, 5, stop);
    if (share == coarse) return fit;
    LawFit other = fitFromShare(finer, best.values, share, stop);
    const auto cost = [&](const LawFit& found) {
        return found.residuals.head(static_cast<Index>(model.returningCount())).squaredNorm();
    };
    if (cost(other) < clearlyBetter * cost(fit)) {
        model = std::move(finer);
        fit = std::move(other);
    }
    return fit;
}

double fitAgain(RecordModel& model, const RecordModel& from, Eigen::VectorXd& values,
                const std::stop_token& stop) {
    const double floor = quietFloor * model.record().peak;
    model.setQuietErrors(floor, floor);
    takeDispersionOf(model, from, values);
    minimise(model, values, 60, stop);
    followDispersion(model, values, stop);
    Eigen::VectorXd residuals;
    model.residuals(values, residuals);
    return residuals.squaredNorm();
}

void searchMinima(RecordModel& model, LawFit& fit, const std::stop_token& stop) {
    constexpr double mostRise = 15, mostRiseOfMinimum = 8;  // of Σr²; 95 % of three unknowns are below 8
    const double sameGap = 5e-6 * model.record().gapScale;  // [m]
    const std::size_t unknown = model.find(Unknown::Kind::gap);
    const auto gap = static_cast<Index>(unknown);
    const double own = fit.values[gap];
    std::vector<Start> minima{{fit.values, fit.cost}}, held;
    for (const double trial : {0.0, own / 2, own + 8 * sameGap, own + 20 * sameGap}) {
        if (stop.stop_requested()) return;
        if (std::abs(trial - own) < sameGap) continue;
        Start other{fit.values, 0};
        other.values[gap] = trial;
        model.unknowns()[unknown].isHeld = true;
        other.cost = minimise(model, other.values, 20, stop);
        held.push_back(other);
        model.unknowns()[unknown].isHeld = false;
        other.cost = minimise(model, other.values, 40, stop);
        minima.push_back(std::move(other));
    }
    const Start lowest = *std::ranges::min_element(minima, {}, &Start::cost);
    const double scale = std::max(1.0, lowest.cost / static_cast<double>(model.returningCount()));
    if (lowest.cost < fit.cost) fit = finished(model, lowest.values);
    const auto keep = [&](const std::vector<Start>& found, double most, bool areMinima) {
        for (const Start& other : found) {
            const double rise = (other.cost - lowest.cost) / scale;
            if (rise < most && std::abs(other.values[gap] - fit.values[gap]) > sameGap)
                fit.nearby.push_back({other.values, rise, areMinima});
        }
    };
    keep(minima, mostRiseOfMinimum, true);
    keep(held, mostRise, false);
}

void refit(RecordModel& model, LawFit& fit, const std::stop_token& stop) {
    minimise(model, fit.values, 60, stop);
    fit = finished(model, fit.values);
}

LawFit fitNearby(RecordModel& model, RecordModel& bilinear, const LawFit& from, const std::stop_token& stop) {
    using Kind = Unknown::Kind;
    const QuietErrors errors = quietErrors(bilinear, from.values);
    model.setQuietErrors(errors.before, errors.last);
    takeDispersionOf(model, bilinear, from.values);
    Eigen::VectorXd values = startValues(model);
    for (std::size_t j = 0; j < model.unknowns().size(); ++j) {
        const Unknown& unknown = model.unknowns()[j];
        const std::size_t same = unknown.kind == Kind::shape
                                     ? bilinear.shapeUnknown(model.shapes()[unknown.index].key)
                                     : bilinear.find(unknown.kind, unknown.index);
        double& value = values[static_cast<Index>(j)];
        if (same < bilinear.unknowns().size()) value = from.values[static_cast<Index>(same)];
        if (unknown.kind == Kind::memory) value = 0.02 * model.record().peak;
        if (unknown.kind == Kind::cornerSlope) value = std::log(0.85);
    }
    const double largest = largestForce(bilinear, from);
    if (model.law() == TrialLaw::corner && largest > 0)
        values[static_cast<Index>(model.find(Kind::cornerForce))] = std::log(0.5 * largest);
    double cost = minimise(model, values, 30, stop);
    if (model.law() == TrialLaw::corner && largest > 0) {
        const auto force = static_cast<Index>(model.find(Kind::cornerForce));
        for (const double part : {0.2, 0.4, 0.6, 0.8}) {
            Eigen::VectorXd other = values;
            other[force] = std::log(part * largest);
            const double found = minimise(model, other, 30, stop);
            if (found >= cost) continue;
            cost = found;
            values = other;
        }
    }
    LawFit fit;
    fit.law = model.law();
    fit.values = std::move(values);
    model.residuals(fit.values, fit.residuals);
    fit.cost = fit.residuals.squaredNorm();
    return fit;
}

LawFit fitFrom(RecordModel& model, RecordModel& bilinear, const LawFit& from, bool isFarOff,
               const std::stop_token& stop) {
    // The weights of a law that does not fit would let the zero lines go.
    const double floor = quietFloor * model.record().peak;
    const QuietErrors errors = isFarOff ? QuietErrors{} : quietErrors(bilinear, from.values);
    model.setQuietErrors(std::max(errors.before, floor), std::max(errors.last, floor));
    model.holdSizes(true);
    // A law that does not fit may have bent the dispersion, too.
    const bool isFree = bilinear.hasDispersion();
    std::vector<double> shares{bilinear.dispersionShare(from.values)};
    if (isFree && isFarOff)
        for (const double share : {0.0, 0.5, 1.0})
            if (std::abs(share - shares.front()) > 0.1) shares.push_back(share);
    Start best;
    double bestShare = shares.front();
    const std::size_t most = model.law() == TrialLaw::corner ? 8 : 2;
    for (const double share : shares) {
        model.setDispersion(share, false);
        Start found = bestOf(model, startsFrom(model, bilinear, from), most, stop);
        if (model.law() == TrialLaw::corner) {
            // Free zero lines lead some starts astray.
            const std::vector<std::size_t> held = holdZeroLines(model);
            Start other = bestOf(model, startsFrom(model, bilinear, from), most, stop);
            for (const std::size_t u : held) model.unknowns()[u].isHeld = false;
            other.cost = minimise(model, other.values, 25, stop);
            if (other.cost < found.cost) found = std::move(other);
        }
        if (best.values.size() > 0 && found.cost >= best.cost) continue;
        best = std::move(found);
        bestShare = share;
    }
    model.setDispersion(bestShare, false);
    if (isFree && model.law() == TrialLaw::corner) searchShare(model, best, bestShare, 0.08, 6, stop);
    Eigen::VectorXd values = best.values;
    if (isFree) takeDispersion(model, values, bestShare, true);
    minimise(model, values, 40, stop);
    model.holdSizes(false);
    minimise(model, values, 60, stop);
    followDispersion(model, values, stop);
    followQuiet(model, values, stop);
    LawFit fit = finished(model, values);
    searchWithoutZeroLines(model, fit, stop);
    return fit;
}

}  // namespace drillwave
