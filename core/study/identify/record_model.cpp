// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/identify/record_model.h"

#include <algorithm>
#include <cmath>

#include "core/study/identify/bar_dispersion.h"
#include "core/study/identify/even_samples.h"

namespace drillwave {

namespace {

constexpr double leadTime = 24e-6;         ///< of the model before the front [s]
constexpr double longestLag = 60e-6;       ///< about the arrival [s]
constexpr double coarsestGrid = 0.6e-6;    ///< [s]
constexpr double returnMargin = 8e-6;      ///< b is compared from before D0 on [s]
constexpr double smoothingSteps = 1.5;     ///< Gaussian of model and b against the grid
constexpr double tailCoherence = 100e-6;   ///< a tail hangs together over that [s]
constexpr double leastWeightShare = 2e-4;  ///< of the peak: noise below that is of cells and interpolation
constexpr double zeroTolerance = 0.02;     ///< of the peak, and in a millisecond
constexpr double droopTolerance = 0.3;     ///< 1 ms over the time constant
constexpr double bendingTolerance = 0.08;  ///< of half the difference of a pair stays in the mean
constexpr double curveTolerance = 0.04;    ///< of the peak: gain at the peak less than at small values
constexpr double risingTolerance = 0.01;   ///< of the peak: more than at small values, of a bar
constexpr double returnTolerance = 0.02;   ///< gain of the returning wave against that of the incident one
constexpr double leastBending = 0.005;     ///< of the peak
constexpr std::size_t frontReach = 4;      ///< samples over which the smoothing spreads a front

double knownOr(const IdentifyQuestion& question, const char* key, double otherwise) {
    for (const KnownTolerance& known : question.known)
        if (known.key == key) return known.tolerance;
    return otherwise;
}

BarDispersion barOf(const GaugePlace& place) {
    return {place.section.diameter / 2, place.section.bore / 2, place.waveSpeed};
}

}  // namespace

RecordModel::RecordModel(const PreparedRecord& record, const IdentifyQuestion& question,
                         const SizeTolerances& sizes, TrialLaw law)
    : m_record(&record),
      m_law(law),
      m_dispersion(question.dispersion),
      m_gridStep(record.step / std::ceil(record.step / coarsestGrid)),
      m_gridStart(-leadTime),
      m_chain(record.places.front().end, m_gridStep) {
    const GaugePlace& place = record.places.front();
    m_attenuated = std::exp(-place.attenuation * place.ahead);
    // Short sections need cells that fit into them.
    double shortest = m_gridStep;
    for (const EndSection& section : place.end.sections) shortest = std::min(shortest, section.transitTime);
    if (shortest < m_gridStep) m_gridStep /= std::min(4.0, std::ceil(m_gridStep / shortest));
    m_chain = ChainModel(place.end, m_gridStep);

    const double arrival = record.roundTrip + record.shift;
    const auto last = std::min(
        record.count() - 1, record.front + static_cast<std::size_t>(std::max(0.0, record.end / record.step)));
    m_firstReturning =
        record.front + static_cast<std::size_t>(std::max(0.0, (arrival - returnMargin) / record.step));
    m_gridCount = static_cast<std::size_t>((record.end - arrival + leadTime + longestLag) / m_gridStep) + 4;
    m_waves = separateWaves(record);
    m_returning.assign(m_waves.returning.begin() + static_cast<std::ptrdiff_t>(m_firstReturning),
                       m_waves.returning.begin() + static_cast<std::ptrdiff_t>(last + 1));
    if (!record.isPair()) {
        m_firstQuiet = record.front + static_cast<std::size_t>(record.quietFrom / record.step);
        const std::vector<double>& p = record.gauges.front().force;
        for (std::size_t i = m_firstQuiet; i < p.size() && record.timeOf(i) < record.incidentEnd; ++i)
            m_quiet.push_back(p[i]);
    }
    m_incident = onGrid(m_waves.incident);
    m_weight = 1 / (std::sqrt(2.0) *
                    std::max(record.gauges.front().noise.longRun(), leastWeightShare * record.peak));
    m_quietWeights.assign(m_quiet.size(), m_weight);
    setShares();

    if (law == TrialLaw::held) {
        const BitRock& rock = question.scenario.bitRock;
        m_heldRock.gap = rock.gap;
        m_heldRock.elastic = rock.stiffness / rock.gamma;
        m_heldRock.lines = {{0, rock.stiffness}};
        if (rock.law == RockLaw::corners)
            for (const RockCorner& corner : rock.corners)
                m_heldRock.lines.push_back({corner.force, corner.slope * rock.stiffness});
        if (rock.law == RockLaw::power)
            m_heldRock.lines =
                powerLines(rock.stiffness, rock.exponent, rock.stiffness * rock.referencePenetration);
    }
    addUnknowns(question, sizes);
    addShapes(question);
    setRows();
}

void RecordModel::addUnknowns(const IdentifyQuestion& question, const SizeTolerances& sizes) {
    using Kind = Unknown::Kind;
    const double shift = m_record->shift;
    const auto add = [&](Kind kind, double step, double low, double high, std::size_t index = 0,
                         double tolerance = 0, bool isHeld = false) {
        m_unknowns.push_back({kind, index, step, low, high, 0, tolerance / half95, isHeld});
    };
    if (m_law != TrialLaw::held) {
        add(Kind::stiffness, 1e-3, std::log(1e5), std::log(2e11));
        add(Kind::gamma, 1e-3, std::log(0.01), 0);
        add(Kind::gap, 2e-6 * m_record->gapScale, 0, 8e-3 * m_record->gapScale);
    }
    add(Kind::lag, 0.02e-6, shift - longestLag, shift + longestLag);
    const double impedance = m_record->places.front().end.impedance;
    switch (m_law) {
        case TrialLaw::corner:
            add(Kind::cornerForce, 1e-3, std::log(0.01 * m_record->peak), std::log(2.2 * m_record->peak));
            add(Kind::cornerSlope, 1e-3, std::log(0.01), std::log(20.0));
            break;
        case TrialLaw::power:
            add(Kind::exponent, 1e-3, 0.4, 2.5);
            break;
        case TrialLaw::dashpot:
            add(Kind::dashpot, 1e-2, std::log(1e-3 * impedance), std::log(impedance));
            break;
        case TrialLaw::crater:
            add(Kind::memory, 2e-3 * m_record->peak, 0, 1.5 * m_record->peak);
            break;
        case TrialLaw::bilinear:
        case TrialLaw::held:
            break;
    }
    if (!sizes.lengths.empty() && m_law != TrialLaw::held) {
        const auto addSize = [&](Kind kind, std::size_t index, double tolerance, double bound) {
            if (tolerance > 0)
                add(kind, 0.02 * tolerance / half95, -bound * tolerance, bound * tolerance, index, tolerance);
        };
        addSize(Kind::impedance, 0, sizes.impedance, 2.5);
        for (std::size_t j = 0; j < sizes.lengths.size(); ++j) {
            const double least = 0.8 * m_record->places.front().towardsBit[j].length;
            addSize(Kind::length, j, sizes.lengths[j],
                    std::min(15.0, least / std::max(sizes.lengths[j], 1e-9)));
            addSize(Kind::sectionImpedance, j, sizes.impedances[j], std::min(8.0, 0.8 / sizes.impedances[j]));
        }
    }
    (void)question;
}

void RecordModel::addShape(LinearShape shape, const std::vector<const std::vector<double>*>& signals) {
    const PreparedRecord& record = *m_record;
    const SeparatedWaves waves = separateWaves(record, signals, record.transit);
    shape.incident = onGrid(waves.incident);
    shape.returning.assign(
        waves.returning.begin() + static_cast<std::ptrdiff_t>(m_firstReturning),
        waves.returning.begin() + static_cast<std::ptrdiff_t>(m_firstReturning + m_returning.size()));
    for (std::size_t i = 0; i < m_quiet.size(); ++i) shape.quiet.push_back((*signals[0])[m_firstQuiet + i]);
    m_shapes.push_back(std::move(shape));
    setShapeUnknown(m_shapes.size() - 1);
}

void RecordModel::setShapeUnknown(std::size_t index) {
    const LinearShape& shape = m_shapes[index];
    m_unknowns.push_back({Unknown::Kind::shape, index, 0.02 * shape.deviation, shape.low, shape.high,
                          shape.mean, shape.deviation, false});
}

void RecordModel::addShapes(const IdentifyQuestion& question) {
    const PreparedRecord& record = *m_record;
    const std::size_t count = record.count();
    const std::vector<double> none(count, 0.0);
    const auto shapeOf = [](std::string key, double tolerance) {
        LinearShape shape;
        shape.key = std::move(key);
        shape.tolerance = tolerance;
        shape.deviation = tolerance / half95;
        shape.low = -6 * tolerance;
        shape.high = 6 * tolerance;
        return shape;
    };
    const double zero = knownOr(question, "zero", zeroTolerance);
    for (std::size_t g = 0; g < record.gauges.size(); ++g) {
        const double earlier = g == 0 ? 0 : record.secondShift;
        std::vector<double> offset(count, 0), slope(count, 0);
        for (std::size_t i = 0; i < count; ++i) {
            const double t = record.timeOf(i) + earlier;
            if (t < -20e-6) continue;
            offset[i] = record.peak;
            slope[i] = record.peak * t / 1e-3;
        }
        const std::string number = std::to_string(g + 1);
        const double step = record.gauges[g].recorderStep / 2 / record.peak;
        const auto signals = [&](const std::vector<double>& own) {
            std::vector<const std::vector<double>*> all(record.gauges.size(), &none);
            all[g] = &own;
            return all;
        };
        addShape(shapeOf("offset." + number, zero + step), signals(offset));
        addShape(shapeOf("slope." + number, zero), signals(slope));
    }
    std::vector<std::vector<double>> droops;
    for (const PreparedGauge& gauge : record.gauges) {
        std::vector<double> droop(count, 0);
        double sum = 0;
        for (std::size_t i = record.quiet; i < count; ++i) {
            sum += gauge.force[i] * record.step;
            droop[i] = -sum / 1e-3;
        }
        droops.push_back(std::move(droop));
    }
    std::vector<const std::vector<double>*> all;
    for (const std::vector<double>& droop : droops) all.push_back(&droop);
    addShape(shapeOf("droop", droopTolerance), all);
    // A gain that falls with the signal: soft overload of an amplifier, a bridge that is not linear.
    std::vector<std::vector<double>> curves;
    for (const PreparedGauge& gauge : record.gauges) {
        std::vector<double> slow = gauge.force;
        smoothSamples(slow, record.step, 3e-6);  // noise has no cube
        for (std::size_t i = 0; i < count; ++i)
            slow[i] = record.timeOf(i) < -20e-6 ? 0 : -std::pow(slow[i], 3) / (record.peak * record.peak);
        curves.push_back(std::move(slow));
    }
    all.clear();
    for (const std::vector<double>& curve : curves) all.push_back(&curve);
    LinearShape curvature = shapeOf("curvature", curveTolerance);
    // A larger one makes other forces of a rock that no law fits.
    // A gain that rises and a specimen that yields look alike.
    curvature.low = question.barBehind ? -risingTolerance : -curveTolerance;
    curvature.high = curveTolerance;
    addShape(std::move(curvature), all);
    // A gain that changes between the incident and the returning wave.
    LinearShape gain = shapeOf("gain", returnTolerance);
    std::vector<double> returning = m_waves.returning;
    smoothSamples(returning, record.step, 3e-6);
    const auto first = returning.begin() + static_cast<std::ptrdiff_t>(m_firstReturning);
    gain.incident.assign(m_gridCount, 0);
    gain.returning.assign(first, first + static_cast<std::ptrdiff_t>(m_returning.size()));
    gain.quiet.assign(m_quiet.size(), 0);
    gain.low = -3 * returnTolerance;
    gain.high = 3 * returnTolerance;
    m_shapes.push_back(std::move(gain));
    setShapeUnknown(m_shapes.size() - 1);
    m_unknowns.back().isHeld = question.barBehind;  // a specimen that creeps would take it
    for (std::size_t g = 0; g < record.gauges.size(); ++g) {
        if (record.gauges[g].opposite.empty() || record.bending < leastBending) continue;
        std::vector<const std::vector<double>*> signals(record.gauges.size(), &none);
        signals[g] = &record.gauges[g].opposite;
        addShape(shapeOf("bending." + std::to_string(g + 1), bendingTolerance), signals);
    }
}

double RecordModel::dispersionShare(const Eigen::VectorXd& values) const {
    return m_hasDispersion ? values[static_cast<Eigen::Index>(shapeUnknown("dispersion"))] : heldShare();
}

std::vector<double> RecordModel::dispersed(const std::vector<double>& wave, double way,
                                           const Eigen::VectorXd& values) const {
    return barOf(m_record->places.front()).delayed(wave, m_gridStep, dispersionShare(values) * way);
}

void RecordModel::setDispersion(double share, bool isFree) {
    m_hasDispersion = false;
    const GaugePlace& place = m_record->places.front();
    const std::size_t there = findShape("dispersion");
    if (there < m_shapes.size()) {
        std::erase_if(m_unknowns, [&](const Unknown& unknown) {
            return unknown.kind == Unknown::Kind::shape && unknown.index == there;
        });
        for (Unknown& unknown : m_unknowns)
            if (unknown.kind == Unknown::Kind::shape && unknown.index > there) --unknown.index;
        m_shapes.erase(m_shapes.begin() + static_cast<std::ptrdiff_t>(there));
    }
    const BarDispersion bar = barOf(place);
    const auto wavesAt = [&](double kappa) {
        SeparatedWaves waves = m_waves;
        if (kappa == 0) return waves;
        waves.incident = bar.delayed(waves.incident, m_record->step, kappa * place.ahead);
        waves.returning = bar.delayed(waves.returning, m_record->step, -kappa * place.ahead);
        return waves;
    };
    const auto cut = [&](const std::vector<double>& returning) {
        return std::vector<double>(
            returning.begin() + static_cast<std::ptrdiff_t>(m_firstReturning),
            returning.begin() + static_cast<std::ptrdiff_t>(m_firstReturning + m_returning.size()));
    };
    const SeparatedWaves at = wavesAt(share);
    m_incident = onGrid(at.incident);
    m_returning = cut(at.returning);
    if (isFree) {
        constexpr double near = 0.05;
        const SeparatedWaves above = wavesAt(share + near), below = wavesAt(share - near);
        LinearShape shape;
        shape.key = "dispersion";
        shape.mean = 0.5;
        shape.tolerance = 1;
        shape.deviation = 1 / half95;
        shape.low = -0.1;
        shape.high = 1.2;
        const std::vector<double> f1 = onGrid(above.incident), f0 = onGrid(below.incident);
        const std::vector<double> b1 = cut(above.returning), b0 = cut(below.returning);
        double largest = 0;
        shape.incident.resize(f1.size());
        shape.returning.resize(b1.size());
        for (std::size_t i = 0; i < f1.size(); ++i) {
            shape.incident[i] = -(f1[i] - f0[i]) / (2 * near);
            largest = std::max(largest, std::abs(shape.incident[i]));
        }
        for (std::size_t i = 0; i < b1.size(); ++i) shape.returning[i] = -(b1[i] - b0[i]) / (2 * near);
        shape.quiet.assign(m_quiet.size(), 0);
        // The shape is taken off as the zero lines are: what stays is f at κ = 0 of the straight line.
        if (largest > 1e-3 * m_record->peak) {
            for (std::size_t i = 0; i < f1.size(); ++i) m_incident[i] += share * shape.incident[i];
            for (std::size_t i = 0; i < b1.size(); ++i) m_returning[i] += share * shape.returning[i];
            m_shapes.push_back(std::move(shape));
            setShapeUnknown(m_shapes.size() - 1);
            m_unknowns.back().step = 0.01;
            m_hasDispersion = true;
        }
    }
    setRows();
}

void RecordModel::removeJump() {
    const std::size_t there = findShape("jump");
    if (there >= m_shapes.size()) return;
    std::erase_if(m_unknowns, [&](const Unknown& unknown) {
        return unknown.kind == Unknown::Kind::shape && unknown.index == there;
    });
    for (Unknown& unknown : m_unknowns)
        if (unknown.kind == Unknown::Kind::shape && unknown.index > there) --unknown.index;
    m_shapes.erase(m_shapes.begin() + static_cast<std::ptrdiff_t>(there));
    setRows();
}

void RecordModel::setJump(double time, double tolerance) {
    removeJump();
    LinearShape shape;
    shape.key = "jump";
    shape.tolerance = tolerance;
    shape.deviation = tolerance / half95;
    shape.low = -4 * tolerance;
    shape.high = 4 * tolerance;
    std::vector<double> step(m_record->count(), 0), none(m_record->count(), 0);
    for (std::size_t i = 0; i < step.size(); ++i)
        step[i] = m_record->peak * std::clamp((m_record->timeOf(i) - time) / m_record->step + 0.5, 0.0, 1.0);
    std::vector<const std::vector<double>*> signals(m_record->gauges.size(), &none);
    signals[0] = &step;
    addShape(std::move(shape), signals);
    setRows();
}

void RecordModel::holdSizes(bool isHeld) {
    for (Unknown& unknown : m_unknowns)
        if (unknown.kind == Unknown::Kind::impedance || unknown.kind == Unknown::Kind::length ||
            unknown.kind == Unknown::Kind::sectionImpedance)
            unknown.isHeld = isHeld;
}

void RecordModel::setQuietErrors(double before, double last) {
    for (std::size_t i = 0; i < m_quiet.size(); ++i) {
        const double t = m_record->timeOf(m_firstQuiet + i);
        const double error =
            std::max(quietFloor * m_record->peak, t < m_record->incidentEnd - 120e-6 ? before : last);
        m_quietWeights[i] =
            m_weight * std::min(1.0, std::sqrt(m_record->step / tailCoherence) / (m_weight * error));
    }
}

void RecordModel::setShares() {
    // Differences that noise makes are no fronts.
    const double noise = frontNoise * m_record->gauges.front().noise.deviation();
    std::vector<double> errors(m_returning.size(), 0);
    for (std::size_t i = 1; i < errors.size(); ++i)
        errors[i] = frontError * std::max(0.0, std::abs(m_returning[i] - m_returning[i - 1]) - noise);
    m_shares.assign(errors.size(), 1);
    for (std::size_t i = 0; i < errors.size(); ++i) {
        double largest = 0;
        const std::size_t last = std::min(errors.size(), i + frontReach + 1);
        for (std::size_t k = i > frontReach ? i - frontReach : 0; k < last; ++k)
            largest = std::max(largest, errors[k]);
        m_shares[i] = 1 / std::hypot(1.0, largest * m_weight);
    }
}

void RecordModel::setRows() {
    m_rows = m_returning.size() + m_quiet.size() + m_unknowns.size();
}

std::size_t RecordModel::priorRow(std::size_t unknown) const {
    return m_returning.size() + m_quiet.size() + unknown;
}

std::size_t RecordModel::find(Unknown::Kind kind, std::size_t index) const {
    for (std::size_t i = 0; i < m_unknowns.size(); ++i)
        if (m_unknowns[i].kind == kind && m_unknowns[i].index == index) return i;
    return m_unknowns.size();
}

std::size_t RecordModel::findShape(const std::string& key) const {
    for (std::size_t i = 0; i < m_shapes.size(); ++i)
        if (m_shapes[i].key == key) return i;
    return m_shapes.size();
}

std::size_t RecordModel::shapeUnknown(const std::string& key) const {
    return find(Unknown::Kind::shape, findShape(key));
}

std::vector<double> RecordModel::onGrid(const std::vector<double>& incident) const {
    std::vector<double> grid(m_gridCount);
    const double first = m_gridStart / m_record->step + static_cast<double>(m_record->front);
    const double ratio = m_gridStep / m_record->step;
    for (std::size_t n = 0; n < m_gridCount; ++n)
        grid[n] = sampleAt(incident, first + static_cast<double>(n) * ratio);
    return grid;
}

TrialRock RecordModel::rockOf(const Eigen::VectorXd& values) const {
    if (m_law == TrialLaw::held) return m_heldRock;
    using Kind = Unknown::Kind;
    TrialRock rock;
    const auto at = [&](Kind kind) { return values[static_cast<Eigen::Index>(find(kind))]; };
    const std::size_t relative = find(Kind::impedance);
    const double scale = relative < m_unknowns.size() ? 1 + values[static_cast<Eigen::Index>(relative)] : 1;
    const double stiffness = std::exp(at(Kind::stiffness)) / scale, gamma = std::exp(at(Kind::gamma));
    rock.elastic = stiffness / gamma;
    rock.gap = at(Kind::gap);
    rock.lines = {{0, stiffness}};
    if (m_law == TrialLaw::corner) {
        const double slope = std::min(std::exp(at(Kind::cornerSlope)), 1 / gamma);
        rock.lines.push_back({std::exp(at(Kind::cornerForce)) / scale, slope * stiffness});
    }
    if (m_law == TrialLaw::power) {
        rock.lines = powerLines(stiffness, at(Kind::exponent), m_record->peak / 2);
        for (TrialLine& line : rock.lines) line.slope = std::min(line.slope, rock.elastic);
    }
    if (m_law == TrialLaw::crater)
        rock.lines = {{0, rock.elastic}, {std::max(0.0, at(Kind::memory)) / scale, stiffness}};
    if (m_law == TrialLaw::dashpot) rock.dashpot = std::exp(at(Kind::dashpot));
    return rock;
}

RockEnd RecordModel::endOf(const Eigen::VectorXd& values) const {
    const GaugePlace& place = m_record->places.front();
    RockEnd end = place.end;
    double scale = 1;
    for (std::size_t i = 0; i < m_unknowns.size(); ++i) {
        const Unknown& unknown = m_unknowns[i];
        const double value = values[static_cast<Eigen::Index>(i)];
        if (unknown.kind == Unknown::Kind::impedance) scale = 1 + value;
        for (EndSection& section : end.sections) {
            if (section.source != unknown.index) continue;
            if (unknown.kind == Unknown::Kind::length)
                section.transitTime *= 1 + value / place.towardsBit[section.source].length;
            if (unknown.kind == Unknown::Kind::sectionImpedance) section.impedance *= 1 + value;
        }
    }
    for (EndSection& section : end.sections) section.impedance /= scale;
    for (EndJoint& joint : end.joints) joint.mass /= scale;
    end.bitMass /= scale;
    return end;
}

void RecordModel::runModel(const Eigen::VectorXd& values, bool keepsRock) {
    m_now = m_incident;
    for (std::size_t i = 0; i < m_unknowns.size(); ++i) {
        if (m_unknowns[i].kind != Unknown::Kind::shape) continue;
        const double amount = values[static_cast<Eigen::Index>(i)];
        if (amount == 0) continue;
        const std::vector<double>& shape = m_shapes[m_unknowns[i].index].incident;
        for (std::size_t n = 0; n < m_now.size(); ++n) m_now[n] -= amount * shape[n];
    }
    if (m_attenuated < 1)
        for (double& value : m_now) value *= m_attenuated;
    const TrialRock rock = rockOf(values);
    if (m_record->places.front().end.sections.empty())
        m_chain.run(rock, m_now, m_gridCount, keepsRock);
    else
        m_chain.run(endOf(values), rock, m_now, m_gridCount, keepsRock);
    const double lag = values[static_cast<Eigen::Index>(find(Unknown::Kind::lag))];
    const double start = m_record->timeOf(m_firstReturning) - m_record->roundTrip - lag - m_gridStart;
    const double ratio = m_record->step / m_gridStep;
    m_model.resize(m_returning.size());
    const std::vector<double>& returned = m_chain.returned();
    for (std::size_t i = 0; i < m_model.size(); ++i)
        m_model[i] = m_attenuated * sampleAt(returned, start / m_gridStep + static_cast<double>(i) * ratio);
}

const ChainModel& RecordModel::solved(const Eigen::VectorXd& values) {
    runModel(values, true);
    return m_chain;
}

void RecordModel::residuals(const Eigen::VectorXd& values, Eigen::VectorXd& result) {
    runModel(values, false);
    result.resize(static_cast<Eigen::Index>(m_rows));
    m_left = m_model;
    for (std::size_t i = 0; i < m_left.size(); ++i) m_left[i] -= m_returning[i];
    const std::size_t returning = m_returning.size();
    for (std::size_t i = 0; i < m_quiet.size(); ++i)
        result[static_cast<Eigen::Index>(returning + i)] = m_quiet[i];
    for (std::size_t u = 0; u < m_unknowns.size(); ++u) {
        const Unknown& unknown = m_unknowns[u];
        const double value = values[static_cast<Eigen::Index>(u)];
        result[static_cast<Eigen::Index>(priorRow(u))] =
            unknown.deviation > 0 ? (value - unknown.mean) / unknown.deviation : 0;
        if (unknown.kind != Unknown::Kind::shape || value == 0) continue;
        const LinearShape& shape = m_shapes[unknown.index];
        for (std::size_t i = 0; i < m_left.size(); ++i) m_left[i] += value * shape.returning[i];
        for (std::size_t i = 0; i < m_quiet.size(); ++i)
            result[static_cast<Eigen::Index>(returning + i)] -= value * shape.quiet[i];
    }
    if (!m_record->isLost.empty())
        for (std::size_t i = 0; i < m_left.size(); ++i)
            if (m_record->isLost[m_firstReturning + i]) m_left[i] = 0;
    smoothSamples(m_left, m_record->step, smoothingSteps * m_record->step);
    for (std::size_t i = 0; i < m_left.size(); ++i)
        result[static_cast<Eigen::Index>(i)] = m_weight * m_shares[i] * m_left[i];
    for (std::size_t i = 0; i < m_quiet.size(); ++i)
        result[static_cast<Eigen::Index>(returning + i)] *= m_quietWeights[i];
}

void RecordModel::changedResiduals(const Eigen::VectorXd& values, const SeparatedWaves& change,
                                   const std::vector<double>& quietChange, Eigen::VectorXd& result) {
    const std::vector<double> incident = m_incident, returning = m_returning, quiet = m_quiet;
    addToRecord(change, quietChange);
    residuals(values, result);
    m_incident = incident;
    m_returning = returning;
    m_quiet = quiet;
}

void RecordModel::addToRecord(const SeparatedWaves& change, const std::vector<double>& quietChange) {
    const std::vector<double> grid = onGrid(change.incident);
    for (std::size_t n = 0; n < m_incident.size(); ++n) m_incident[n] += grid[n];
    for (std::size_t i = 0; i < m_returning.size(); ++i)
        m_returning[i] += change.returning[m_firstReturning + i];
    for (std::size_t i = 0; i < m_quiet.size() && i < quietChange.size(); ++i) m_quiet[i] += quietChange[i];
}

}  // namespace drillwave
