// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/closed/closed_form.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/numeric/power_series.h"
#include "core/text/message.h"
#include "core/text/units.h"
#include "core/wave/impact.h"

namespace drillwave {

namespace {

// Waves that decay with one rate, as pieces of a history.

// f(u) = A + (B + C u) e^(−βu), u ≥ 0.
struct Decay {
    double constant = 0;
    double amplitude = 0;
    double growth = 0;

    double value(double u, double beta) const {
        return constant + (amplitude + growth * u) * std::exp(-beta * u);
    }
    // The same function with u counted from `start`.
    Decay from(double start, double beta) const {
        const double decay = std::exp(-beta * start);
        return {constant, (amplitude + growth * start) * decay, growth * decay};
    }
};

Decay operator-(const Decay& f, const Decay& g) {
    return {f.constant - g.constant, f.amplitude - g.amplitude, f.growth - g.growth};
}

// Appends incident wave and force as power series, exact to rounding, and sums over them.
class DecayPieces {
  public:
    // The pieces go to the histories of `impact`, if there is one.
    DecayPieces(double beta, Impact* impact) : m_beta(beta), m_impact(impact) {}

    // A stretch of that length, both functions counted from its beginning. At most about fifty pieces,
    // however large β is: then nothing is left of the decay.
    void append(double length, Decay incident, Decay force);

    // From here on count the sums of momentum ∫g, energy ∫g² and work on the rock ∫F (2g − F).
    void beginSums() { m_momentum = m_energy = m_rockWork = 0; }
    double momentum() const { return m_momentum; }
    double energy() const { return m_energy; }
    double rockWork() const { return m_rockWork; }
    long count() const { return m_count; }

  private:
    void appendPiece(double length, const Decay& incident, const Decay& force);

    double m_beta;
    Impact* m_impact;
    double m_momentum = 0, m_energy = 0, m_rockWork = 0;
    long m_count = 0;
};

using Series = PowerSeries<double>;

/// The first 22 terms on [0, length], βℓ ≤ 1: the rest is below 1e-21 of the coefficients.
Series seriesOf(const Decay& f, double beta, double length) {
    constexpr int terms = 22;
    Series series = Series::zero(length);
    series.count = terms;
    double power = 1, before = 0;  // (−βℓ)^k/k! and the one before
    for (int k = 0; k < terms; ++k) {
        series.c[k] = f.amplitude * power + f.growth * length * before;
        before = power;
        power *= -beta * length / (k + 1);
    }
    series.c[0] += f.constant;
    series.trim(0);
    return series;
}

bool isDecayed(const Decay& f) {
    constexpr double nothing = 1e-22;
    return std::abs(f.amplitude) + std::abs(f.growth) < nothing;
}

void DecayPieces::append(double length, Decay incident, Decay force) {
    while (length > 0) {
        const bool isConstant = isDecayed(incident) && isDecayed(force);
        const double piece = isConstant ? length : std::min(length, 1 / m_beta);
        if (isConstant) incident = {incident.constant, 0, 0}, force = {force.constant, 0, 0};
        appendPiece(piece, incident, force);
        incident = incident.from(piece, m_beta);
        force = force.from(piece, m_beta);
        length -= piece;
    }
}

void DecayPieces::appendPiece(double length, const Decay& incident, const Decay& force) {
    const Series g = seriesOf(incident, m_beta, length);
    const Series f = seriesOf(force, m_beta, length);
    ++m_count;
    m_momentum += g.integral(length);
    m_energy += Series::productIntegral(g, g, length);
    m_rockWork += 2 * Series::productIntegral(f, g, length) - Series::productIntegral(f, f, length);
    if (!m_impact) return;
    const auto coefficients = [](const Series& series) {
        return std::span(series.c.data(), static_cast<std::size_t>(series.count));
    };
    m_impact->incident.append(length, length, coefficients(g));
    m_impact->force.append(length, length, coefficients(f));
}

/// β1, the positive root of e^x = 2x + 1, of [paper (12)]: above it the second pulse ends while its wave
/// still arrives.
constexpr double beta1 = 1.2564312086261697;

/// 1 − e^(−x) with all its digits.
double saturation(double x) {
    return -std::expm1(-x);
}

// The force pulses as A + (B + C u) e^(−βu): while the wave of duration 1 arrives, u = t, and after it,
// u = t − 1.

Decay firstRise() {
    return {.constant = 2, .amplitude = -2, .growth = 0};  // [paper (11)], t < 1
}
Decay firstFall(double beta) {
    return {.constant = 0, .amplitude = 2 * saturation(beta), .growth = 0};  // [paper (11)], t ≥ 1
}
Decay secondRise(double beta) {
    return {.constant = -2, .amplitude = 2, .growth = 4 * beta};  // [paper (12)] [paper (14)], t < 1
}
Decay secondFall(double beta) {
    const double q = saturation(beta);  // [paper (14)], t ≥ 1
    return {.constant = 0, .amplitude = 2 * (2 * beta - (1 + 2 * beta) * q), .growth = -4 * beta * q};
}

/// The second pulse [paper (12)] [paper (14)], followed beyond its end.
double secondForceBeyond(double beta, double t) {
    if (t < 1) return 2 * (std::expm1(-beta * t) + 2 * beta * t * std::exp(-beta * t));
    return secondFall(beta).value(t - 1, beta);
}

/// How far the wave that returns from the second reflection pushes the front end at most, ∫ of its positive
/// part: 2e^(−βt) − 1 less the force.
double largestPush(double beta) {
    const double until = std::min(1.0, std::log(2) / beta);
    return 2 * saturation(beta * until) / beta - until;
}

/// Waves and force of one round trip, stretch by stretch.
struct RoundTrip {
    struct Stretch {
        double length;
        Decay incident, force;
    };
    std::vector<Stretch> stretches;

    void add(double length, const Decay& incident, const Decay& force = {}) {
        if (length > 0) stretches.push_back({length, incident, force});
    }
};

constexpr Decay pulseWave{.constant = 1, .amplitude = 0, .growth = 0};

RoundTrip freeTrip(double roundTrip) {
    RoundTrip trip;
    trip.add(1, pulseWave);
    trip.add(roundTrip - 1, {});
    return trip;
}

RoundTrip firstTrip(double beta, double roundTrip) {
    RoundTrip trip;
    trip.add(1, pulseWave, firstRise());
    trip.add(roundTrip - 1, {}, firstFall(beta));
    return trip;
}

RoundTrip secondTrip(double beta, double roundTrip) {
    const double end = secondPulseEnd(beta);
    const Decay during = pulseWave - firstRise();  // what came back [paper (6)]
    const Decay after = Decay{} - firstFall(beta);
    RoundTrip trip;
    trip.add(std::min(end, 1.0), during, secondRise(beta));
    trip.add(1 - end, during.from(end, beta));
    trip.add(end - 1, after, secondFall(beta));
    const double apart = std::max(end, 1.0);
    trip.add(roundTrip - apart, after.from(apart - 1, beta));
    return trip;
}

/// The same stretches one round trip later, free.
RoundTrip reflected(const RoundTrip& trip) {
    RoundTrip next;
    for (const auto& [length, incident, force] : trip.stretches) next.add(length, incident - force);
    return next;
}

/// Histories, and the sums over them.
void record(const Problem& problem, Detail detail, Impact& impact) {
    const double beta = problem.law.beta;
    const double periods = std::round(problem.gap);
    const bool keep = detail == Detail::histories;
    DecayPieces pieces(beta, keep ? &impact : nullptr);
    const auto append = [&](const RoundTrip& trip) {
        pieces.beginSums();
        for (const auto& [length, incident, force] : trip.stretches) pieces.append(length, incident, force);
    };
    if (periods > 0) append(freeTrip(impact.roundTrip));
    if (periods > 1 && keep) impact.skips.push_back({impact.roundTrip, (periods - 1) * impact.roundTrip});
    const RoundTrip second = secondTrip(beta, impact.roundTrip);
    append(firstTrip(beta, impact.roundTrip));
    impact.rockWork = pieces.rockWork();
    append(second);
    impact.rockWork += pieces.rockWork();
    append(reflected(second));
    impact.finalMomentum = pieces.momentum();
    impact.finalEnergy = pieces.energy();
    impact.pieces = pieces.count();
}

}  // namespace

double firstForcePulse(double beta, double t) {
    if (t < 0) return 0;
    return t < 1 ? 2 * saturation(beta * t) : firstFall(beta).value(t - 1, beta);  // [paper (11)]
}

double secondForcePulse(double beta, double t) {
    return t < 0 || t >= secondPulseEnd(beta) ? 0.0 : secondForceBeyond(beta, t);
}

double secondPulseEnd(double beta) {
    // ts of [paper (12)], and of [paper (14)]
    return beta > beta1 ? beta1 / beta : 1 / saturation(beta) - 1 / (2 * beta);
}

double secondPulseImpulse(double beta) {
    if (beta > beta1) {
        const double decay = std::exp(-beta1);
        return 2 / beta * (3 * (1 - decay) - beta1 * (1 + 2 * decay));  // [paper (13)]
    }
    const double x = beta / saturation(beta) - 0.5;  // β ts
    // [paper (15)], arranged so that nothing cancels for β → 0
    return 2 * (std::exp(-x) * ((3 + 2 * x) * std::expm1(beta) / beta - 2 * std::exp(beta)) - 1);
}

double closedFormRestitution(double beta) {
    return 1 + secondPulseImpulse(beta);  // [paper (10)]
}

double neglectedOverlap(double beta, double tau) {
    return 2 / beta * saturation(beta) * std::exp(-beta * (2 * tau + secondPulseEnd(beta) - 1));
}

bool overlapIsSmall(double beta, double tau) {
    const bool endsInTime = firstForcePulse(beta, 4 * tau) + secondForceBeyond(beta, 2 * tau) <= 0;
    // The gap that opens until the next wave arrives is at least 2 + I3 − 3∫F1 over what is left at 2τ.
    const double left = firstForcePulse(beta, 2 * tau) / beta;
    return endsInTime && 2 * largestPush(beta) < 2 + secondPulseImpulse(beta) - 3 * left;
}

Message closedFormRefusal(const Problem& problem) {
    if (const std::string_view refusal = rodRefusal(problem); !refusal.empty())
        return Message::ofTable(refusal);
    constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
    Message found;
    const auto add = [&](Message text) { found = joined(std::move(found), "%1, %2", std::move(text)); };
    if (problem.force().shape != PulseShape::rectangular)
        add("pulse.shape = " + std::string(name(problem.force().shape)));
    if (problem.law.gamma != 1) add("gamma = " + formatNumber(problem.law.gamma));
    if (!problem.law.isBilinear()) add(translatable("a loading curve of more than one line"));
    if (std::abs(problem.gap - std::round(problem.gap)) > rounding * std::max(1.0, problem.gap))
        add("delta = " + formatNumber(problem.gap));
    if (problem.transitTime() < 0.5) add("tau = " + formatNumber(problem.transitTime()));
    if (found.isEmpty()) return found;
    return {translatable("the closed form is for a rectangular pulse, gamma = 1, a whole number as delta and "
                         "tau >= 0.5, not %1; use the exact method or the lattice"),
            {found}};
}

Impact solveClosedForm(const Problem& problem, Detail detail) {
    Impact impact;
    impact.reason = closedFormRefusal(problem);
    if (!impact.reason.isEmpty()) return impact;
    const double beta = problem.law.beta;
    if (!overlapIsSmall(beta, problem.transitTime())) {
        impact.reason = translatable(
            "the reflections overlap, which the closed form neglects: the contact is not over when the third "
            "wave arrives; use the exact method or the lattice");
        return impact;
    }
    impact.outcome = Outcome::rebounded;
    impact.cor = closedFormRestitution(beta);
    impact.impulse = 1 + impact.cor;
    impact.corError =
        neglectedOverlap(beta, problem.transitTime()) + 8 * std::numeric_limits<double>::epsilon();
    impact.pieces = 4;
    impact.contacts = 1;
    if (detail == Detail::cor) return impact;

    impact.frontArrival = problem.transitTime();
    impact.roundTrip = 2 * problem.transitTime();
    impact.peakForce = 2 * saturation(beta);  // of the first pulse; the second is never as high
    const double periods = std::round(problem.gap);
    const double loading = problem.transitTime() + periods * impact.roundTrip;
    // A gap of whole δ closes with the end of a wave, and nothing happens until the next one.
    impact.firstContactTime = periods > 0 ? loading - impact.roundTrip + 1 : loading;
    impact.separationTime = loading + impact.roundTrip + secondPulseEnd(beta);
    impact.contactDuration = impact.separationTime - impact.firstContactTime;
    impact.hammerWork = 1;
    impact.events = {{ContactEvent::contact, impact.firstContactTime},
                     {ContactEvent::separation, impact.separationTime}};
    record(problem, detail, impact);
    return impact;
}

}  // namespace drillwave
