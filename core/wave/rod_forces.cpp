#include "core/wave/rod_forces.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "core/wave/wave_field.h"

namespace drillwave {

namespace {

using Piece = PiecewisePolynomial::Piece;

/// On which side of a breakpoint a value is taken.
enum class Side { start, inside, end };

/// Both waves at one time of the front end.
struct Instant {
    double time;
    Side side;
    double incident;   ///< g
    double reflected;  ///< r = F − g
};

/// Follows one sign of the force: the sum of what comes in and the largest of what went back up to one round
/// trip before.
class SlidingMaximum {
  public:
    SlidingMaximum(double sign, double roundTrip) : m_sign(sign), m_roundTrip(roundTrip) {}

    void pass(const Instant& now) {
        const double back = m_sign * now.reflected;
        while (!m_back.empty() && m_back.back().value <= back) m_back.pop_back();
        m_back.push_back({now.time, now.side, back});
        forget(now);
        const double sum = m_sign * now.incident + m_back.front().value;
        if (sum > m_largest) {
            m_largest = sum;
            m_incident = now.time;
            m_reflected = m_back.front().time;
        }
    }

    /// As a place and a global time.
    RodForce found(const Impact& impact) const {
        const double late = std::clamp((m_incident - m_reflected) / m_roundTrip, 0.0, 1.0);  // 1 − ξ
        const double time = timeOfRecorded(impact, m_incident) + impact.frontArrival - late * m_roundTrip / 2;
        return {m_largest, 1 - late, time};
    }

  private:
    struct Back {
        double time;
        Side side;
        double value;
    };

    /// What is reflected at the rear end by now is in g already. A jump that comes back there must not be
    /// added to what it was before: within rounding of one round trip only the later side of the earlier time
    /// and the earlier side of the later one are in the rod together.
    void forget(const Instant& now) {
        const double oldest = now.time - m_roundTrip;
        const double rounding = 8 * std::numeric_limits<double>::epsilon() * (now.time + m_roundTrip);
        const auto isGone = [&](const Back& back) {
            if (std::abs(back.time - oldest) > rounding) return back.time < oldest;
            return now.side != Side::end || back.side != Side::start;
        };
        while (m_back.size() > 1 && isGone(m_back.front())) m_back.pop_front();
    }

    double m_sign;
    double m_roundTrip;
    std::deque<Back> m_back;  ///< falling values
    double m_largest = 0;
    double m_incident = 0, m_reflected = 0;
};

/// How far a wave may bend off the chord between two points that are looked at, as a share of the peak force.
constexpr double tolerance = 1e-4;

/// Into how many parts a piece is cut so that no extremum between them is missed by more than `tolerance`.
int partsOf(std::span<const double> c, double peak) {
    constexpr double most = 64;
    double bend = 0;
    for (std::size_t k = 2; k < c.size(); ++k) bend += double(k * (k - 1)) * std::abs(c[k]);
    return static_cast<int>(std::clamp(std::ceil(std::sqrt(bend / (8 * tolerance * peak))), 1.0, most));
}

/// Calls pass(instant) for both ends of every piece that ends behind `from`, and for points between where a
/// wave is curved.
template <class Pass>
void forEachInstant(const Impact& impact, double from, Pass pass) {
    const auto incident = impact.incident.pieces();
    const auto force = impact.force.pieces();
    const double peak = std::max(impact.peakForce, std::numeric_limits<double>::min());
    for (std::size_t i = 0; i < incident.size(); ++i) {
        const Piece& piece = incident[i];
        if (piece.start + piece.length < from) continue;
        const auto at = [&](double x, Side side) {
            const double g = impact.incident.value(piece, x);
            const double F = force[i].count > 0 ? impact.force.value(force[i], x) : 0;
            pass(Instant{piece.start + x, side, g, F - g});
        };
        const int parts = std::max(partsOf(impact.incident.coefficients(piece), peak),
                                   partsOf(impact.force.coefficients(force[i]), peak));
        at(0, Side::start);
        for (int part = 1; part < parts; ++part) at(piece.length * part / parts, Side::inside);
        at(piece.length, Side::end);
    }
}

/// After the blow the waves run to and fro: each point of them meets every other.
void addWavesThatRemain(const Impact& impact, RodForces& forces) {
    const double from = impact.incident.end() - impact.roundTrip;
    Instant least{}, most{};
    bool first = true;
    forEachInstant(impact, from, [&](const Instant& now) {
        if (now.time < from) return;
        if (first || now.incident > most.incident) most = now;
        if (first || now.incident < least.incident) least = now;
        first = false;
    });
    if (first) return;
    const double size = most.incident - least.incident;
    const auto meeting = [&](const Instant& incoming, const Instant& reflected) {
        const double behind =
            std::fmod(incoming.time - reflected.time + impact.roundTrip, impact.roundTrip);  // a − b
        const double late = behind / impact.roundTrip;
        return RodForce{size, 1 - late,
                        timeOfRecorded(impact, reflected.time) + behind + impact.frontArrival -
                            late * impact.roundTrip / 2};
    };
    if (size > forces.compression.size) forces.compression = meeting(most, least);
    if (size > forces.tension.size) forces.tension = meeting(least, most);
}

/// The peak of the hammer force, which at the rear end is the force in the rod.
void addHammer(const PulseForce& pulse, RodForce& compression) {
    if (!(pulse.peak > compression.size)) return;
    double time = 0;
    for (const PulseSegment& segment : pulse.segments) {
        // Its ends, and the middle of a half sine.
        for (const double part : {0.0, 0.5, 1.0}) {
            const double t = segment.start + part * segment.length;
            if (pulse(t) > pulse(time)) time = t;
        }
    }
    compression = {pulse.peak, 0, time};
}

}  // namespace

RodForces largestRodForces(const Impact& impact, const PulseForce& pulse) {
    SlidingMaximum compression(1, impact.roundTrip), tension(-1, impact.roundTrip);
    // Before the first front the rod is free of force: nothing, or a uniform motion.
    const double before = incidentWave(impact, -impact.roundTrip / 2);
    const Instant quiet{0, Side::end, before, -before};
    compression.pass(quiet);
    tension.pass(quiet);
    forEachInstant(impact, 0, [&](const Instant& now) {
        compression.pass(now);
        tension.pass(now);
    });
    RodForces forces{compression.found(impact), tension.found(impact)};
    addWavesThatRemain(impact, forces);
    addHammer(pulse, forces.compression);
    return forces;
}

}  // namespace drillwave
