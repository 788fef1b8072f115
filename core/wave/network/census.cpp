// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/census.h"

#include <algorithm>
#include <cmath>

#include "core/numeric/gauss_rule.h"

namespace drillwave {

LineCensus::LineCensus(double from, double to, double decay, double before)
    : m_from(from), m_to(to), m_decay(decay) {
    const double length = std::min(to, 0.0) - std::min(from, 0.0);
    m_sums.entered = m_sums.present = length * before;
    m_sums.enteredSquare = m_sums.presentSquare = length * before * before;
}

/// A cell of which a part is in the line.
void LineCensus::addAcross(const WaveCell& cell, double start, double width) {
    const double from = std::clamp((m_from - start) / width, 0.0, 1.0);
    const double to = std::clamp((m_to - start) / width, 0.0, 1.0);
    if (from > 0) {
        const WaveCell gone = cell.part(0, from);
        m_sums.passed += from * width * gone.mean();
        m_sums.passedSquare += from * width * gone.meanSquare();
    }
    const double inside = (to - from) * width;
    const WaveCell part = from > 0 || to < 1 ? cell.part(from, to) : cell;
    m_sums.entered += inside * part.mean();
    m_sums.enteredSquare += inside * part.meanSquare();
    double more = 0, moreSquare = 0;  // than this part of the cell tells
    if (m_entered && m_entered->start == start) {
        const WaveCell told = cell.part(0, to);
        more = to * width * (m_entered->part.mean() - told.mean());
        moreSquare = to * width * (m_entered->part.meanSquare() - told.meanSquare());
    }
    m_sums.entered += more;
    m_sums.enteredSquare += moreSquare;
    if (m_decay == 0) {
        m_sums.present = m_sums.entered;
        m_sums.presentSquare = m_sums.enteredSquare;
        return;
    }
    m_sums.present += more;
    m_sums.presentSquare += moreSquare;
    const double rate = m_decay / (m_to - m_from);
    const GaussRule& rule = gaussRule();
    for (std::size_t i = 0; i < GaussRule::count; ++i) {
        const double age = m_to - (start + (from + (to - from) * rule.nodes[i]) * width);
        const double amplitude = part.value(rule.nodes[i]) * std::exp(-rate * age);
        m_sums.present += inside * rule.weights[i] * amplitude;
        m_sums.presentSquare += inside * rule.weights[i] * amplitude * amplitude;
    }
}

void StringClocks::begin(std::size_t hammerSections, const std::vector<double>& times) {
    transitTimes = times;
    delays.clear();
    double delay = 0;
    for (std::size_t j = 0; j < hammerSections; ++j) delay -= times[j];
    delays.push_back(delay);
    for (std::size_t j = 0; j < times.size(); ++j) {
        // the face is the origin: no rounding of the hammer goes on into the string
        delay = j + 1 == hammerSections ? 0 : delay + times[j];
        delays.push_back(delay);
    }
}

void StringCensus::begin(const Problem& problem, const StringClocks& clocks, double time) {
    m_problem = &problem;
    m_clocks = &clocks;
    m_isUnderWay = true;
    m_result = {.time = time, .bit = BitNodeState(ContactLaw<double>(problem.law), problem.distance())};
    m_down.clear();
    m_up.clear();
    m_massVelocities.clear();
    for (std::size_t j = 0; j < problem.sections.size(); ++j) {
        const UniformSection& section = problem.sections[j];
        const bool hammer = j < problem.hammerSections();
        const double v = hammer ? problem.hammer().velocity : 0;
        const double wave = v * section.impedance / 2;
        m_down.emplace_back(clockOf(j + 1), clockOf(j), section.decay, wave);
        m_up.emplace_back(clockOf(j + 1) - clocks.transitTimes[j], clockOf(j + 1), section.decay, -wave);
        m_massVelocities.push_back(v);
    }
}

CensusResult StringCensus::finish() {
    m_isUnderWay = false;
    CensusResult result = m_result;
    for (std::size_t j = 0; j < m_down.size(); ++j) {
        const UniformSection& section = m_problem->sections[j];
        const LineSums& down = m_down[j].sums();
        const LineSums& up = m_up[j].sums();
        const double z = section.impedance;
        const bool isBit = j + 1 == m_down.size();
        const double v = isBit ? result.bit.velocity : m_massVelocities[j];
        const double momentum = down.present - up.present + section.massAfter * v;
        const double energy = (down.presentSquare + up.presentSquare) / z + section.massAfter * v * v / 2;
        const bool hammer = j < m_problem->hammerSections();
        (hammer ? result.hammerMomentum : result.stringMomentum) += momentum;
        (hammer ? result.hammerEnergy : result.stringEnergy) += energy;
        if (section.decay > 0) {
            const double kept = std::exp(-section.decay);
            const auto lost = [&](const LineSums& sums) {
                return (1 - kept * kept) * sums.passedSquare + sums.enteredSquare - sums.presentSquare;
            };
            const auto given = [&](const LineSums& sums) {
                return (1 - kept) * sums.passed + sums.entered - sums.present;
            };
            result.rodLoss += (lost(down) + lost(up)) / z;
            result.externalMomentum += given(down) - given(up);
        }
        if (j > 0 && m_problem->sections[j - 1].loss > 0) {
            const double passing = std::sqrt(1 - m_problem->sections[j - 1].loss);
            const double kept = std::exp(-section.decay);
            const double before = (down.passedSquare + down.enteredSquare) / (passing * passing);
            const double back = kept * kept * up.passedSquare;
            result.jointLoss += (1 - passing * passing) * (before + back) / z;
            result.externalMomentum +=
                (1 - passing) * ((down.passed + down.entered) / passing - kept * up.passed);
        }
    }
    if (!m_problem->isForced() && m_problem->hammer().face.stiffness && !result.face.apart)
        result.faceEnergy = result.face.force * result.face.force / (2 * *m_problem->hammer().face.stiffness);
    return result;
}

namespace {

/// A free body of sections in a row: how far its ends may move away from its centre of mass.
struct FreeBody {
    double mass = 0;
    double frontCompliance = 0, rearCompliance = 0;  ///< ∫(M/m)² dx/(EA), M behind or before x
};

FreeBody freeBody(const Problem& problem, std::size_t first, std::size_t last) {
    FreeBody body;
    for (std::size_t j = first; j < last; ++j)
        body.mass += problem.sections[j].mass() + problem.sections[j].massAfter;
    double behind = 0;
    for (std::size_t j = first; j < last; ++j) {
        const UniformSection& section = problem.sections[j];
        const double compliance = section.transitTime / section.impedance, mass = section.mass();
        const auto square = [mass](double m) { return m * m + m * mass + mass * mass / 3; };
        body.frontCompliance += compliance * square(behind);
        body.rearCompliance += compliance * square(body.mass - behind - mass);
        behind += mass + section.massAfter;
    }
    body.frontCompliance /= body.mass * body.mass;
    body.rearCompliance /= body.mass * body.mass;
    return body;
}

double deviation(double energy, double momentum, double mass, double compliance) {
    const double internal = std::max(0.0, energy - momentum * momentum / (2 * mass));
    return std::sqrt(2 * internal * compliance);
}

/// How long it takes until a way has shrunk to nothing at this speed; nothing where it does not.
std::optional<double> timeToLose(double way, double speed) {
    if (speed < 0) return {};
    if (way <= 0) return 0.0;
    if (speed == 0) return {};
    return way / speed;
}

}  // namespace

std::optional<double> restTime(const Problem& problem, const CensusResult& census) {
    if (!census.bit.isApart() || !census.face.apart) return {};
    const FreeBody string = freeBody(problem, problem.hammerSections(), problem.sections.size());
    const double stringSpeed = census.stringMomentum / string.mass;
    const BitRecord& rock = census.bit.record;
    const FaceRecord& face = census.face.record;
    // ways of the centres of mass: ∫(t − t') F dt'/m
    const double pushed = census.time * face.impulse - face.impulseMoment;
    const double held = census.time * rock.impulse - rock.impulseMoment;
    const double stringWay = (pushed - held) / string.mass;
    const double front =
        deviation(census.stringEnergy, census.stringMomentum, string.mass, string.frontCompliance);
    const auto rockRest = timeToLose(
        stringWay + front - problem.distance() - census.bit.law.residualPenetration(), -stringSpeed);
    if (!rockRest || census.face.released) return rockRest ? census.time + *rockRest : rockRest;
    const FreeBody hammer = freeBody(problem, 0, problem.hammerSections());
    const double hammerSpeed = census.hammerMomentum / hammer.mass;
    const double hammerWay = problem.hammer().velocity * census.time - pushed / hammer.mass;
    const double rear =
        deviation(census.stringEnergy, census.stringMomentum, string.mass, string.rearCompliance);
    const double hammerFront =
        deviation(census.hammerEnergy, census.hammerMomentum, hammer.mass, hammer.frontCompliance);
    const auto faceRest = timeToLose(rear + hammerFront - stringWay + hammerWay, stringSpeed - hammerSpeed);
    if (!faceRest) return {};
    return census.time + std::max(*rockRest, *faceRest);
}

}  // namespace drillwave
