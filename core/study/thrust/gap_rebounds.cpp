// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/thrust/gap_rebounds.h"

namespace drillwave {

namespace {

/// So many results are remembered at most: a few hundred kilobytes.
constexpr std::size_t mostRemembered = 4096;

GapRebound missing(const GapCurve& curve) {
    return {.cor = {}, .reason = curve.reason, .stopped = curve.stopped};
}

/// Returns the remembered value for `key`; otherwise finds and remembers it.
template <typename Key, typename Find>
GapRebound remembered(std::map<Key, GapRebound>& memory, const Key& key, const Find& find) {
    if (const auto known = memory.find(key); known != memory.end()) return known->second;
    const GapRebound found = find();
    if (found.stopped) return found;
    if (memory.size() >= mostRemembered) memory.clear();
    return memory.emplace(key, found).first->second;
}

}  // namespace

GapCurve rockCurve(const Problem& problem, const std::stop_token& stop, const GapProgress& progress,
                   long mostPieces) {
    return gapCurve(problem, Detail::cor, stop, progress, mostPieces);
}

GapCurve elasticCurve(Problem problem, const std::stop_token& stop, const GapProgress& progress,
                      long mostPieces) {
    problem.law = {.beta = problem.law.beta, .gamma = 1};
    return gapCurve(problem, 0, Detail::cor, stop, progress, mostPieces);
}

GapRebound quantileOf(const GapCurve& rock) {
    if (!rock.isComplete()) return missing(rock);
    return {.cor = gapStatistics(rock).of(GapOutput::cor).uniform.quantiles.back(), .reason = {}};
}

GapRebound worstOf(const GapCurve& elastic) {
    if (!elastic.isComplete()) return missing(elastic);
    return {.cor = largestCor(elastic), .reason = {}};
}

GapRebounds GapReboundFinder::of(const Problem& problem, const std::stop_token& stop) {
    forgetOtherThan(problem);
    const double beta = problem.law.beta, gamma = problem.law.gamma, tau = problem.transitTime();
    return {.quantile = remembered(m_quantiles, {beta, gamma, tau},
                                   [&] { return quantileOf(rockCurve(problem, stop, {}, m_mostPieces)); }),
            .worst = remembered(m_worst, {beta, tau},
                                [&] { return worstOf(elasticCurve(problem, stop, {}, m_mostPieces)); })};
}

void GapReboundFinder::remember(const Problem& problem, const GapRebounds& rebounds) {
    forgetOtherThan(problem);
    const double beta = problem.law.beta, gamma = problem.law.gamma, tau = problem.transitTime();
    m_quantiles[{beta, gamma, tau}] = rebounds.quantile;
    m_worst[{beta, tau}] = rebounds.worst;
}

void GapReboundFinder::forgetOtherThan(const Problem& problem) {
    BitRockLaw shape = problem.law;
    shape.beta = shape.gamma = 1;
    if (m_hammer == problem.force() && m_shape == shape) return;
    m_hammer = problem.force();
    m_shape = shape;
    m_quantiles.clear();
    m_worst.clear();
}

}  // namespace drillwave
