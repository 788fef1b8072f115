// SPDX-License-Identifier: GPL-3.0-or-later
// Contact solved with power series on short pieces: robust for every rate, hammer force and number of
// reflections.
#pragma once

#include "core/contact/bit_rock_law.h"
#include "core/numeric/compensated_sum.h"
#include "core/numeric/first_zero.h"
#include "core/numeric/power_series.h"
#include "core/wave/exact/series_joiner.h"
#include "core/wave/exact/stretch_end.h"
#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Representation of the waves of ContactMarch by truncated power series.
///
/// For a piece of contact with rate a and length ℓ, the recurrence of F' = a(2g − F) is summed directly if aℓ
/// ≲ 2. If aℓ is larger, the piece is cut, unless F follows the slow solution F = 2g − F'/a. For a polynomial
/// g that is an exact polynomial, so one piece is enough, however large a is.
template <class RealType>
class SeriesBasis {
  public:
    using Real = RealType;
    using Piece = WavePiece<Real>;
    using Sum = CompensatedSum<Real>;
    /// Rounding error of each term added to a Sum, relative to the sum; it is 0, because sums are
    /// compensated.
    static constexpr Real roundingOfSums = 0;
    /// Whether neighbouring pieces of waves are joined to save work.
    static constexpr bool joinsPieces = true;

    /// Solution for one stretch of contact: the arriving wave g and the force F as power series on the same
    /// scale.
    struct Response {
        /// Length of the stretch of contact, in units of t0.
        Real length = 0;
        /// Arriving wave g, which must outlive the response; it may point to `cut`.
        const Piece* incident = nullptr;
        /// First part of the arriving wave, as a series whose scale is its own length; `incident` may point
        /// to it.
        Piece cut;
        /// Impact force F over the stretch, in units of F0.
        Piece force;
        /// Product aℓ of the contact's rate a and the length ℓ of the stretch.
        Real alpha = 0;
        /// Whether F is the slow solution 2g − F'/a, without the initial layer in which F approaches it. Its
        /// slope then cannot be computed from 2g − F.
        bool isSlow = false;
        /// Sum of the absolute coefficients of the response, in units of F0; times the machine epsilon, it
        /// estimates the rounding error.
        Real size = 0;
    };

    /// Prepares the representation for a blow with the given bit–rock law.
    void begin(const Problem& problem, const ContactLaw<Real>& law) {
        m_undecided = false;
        m_count = {};
        m_scale = std::max(Real(problem.force().peak), 1 / (2 * Real(problem.transitTime())));
        if (!problem.force().isRigidBody() && problem.transitTime() >= 0.5)
            m_scale = Real(problem.force().peak);
        const JoiningBudget budget(problem);
        m_joiner.begin(budget, law.slopes().elastic);
        m_joiningError.begin(budget, law.slopes().elastic);
        m_negligible = std::ldexp(m_scale, negligibleExponent);
    }
    /// Number of pieces of the wave in a round trip from which on joining pieces saves work.
    static constexpr std::size_t manyPieces = 32;

    /// Returns whether a search for a contact event has failed, so that the blow cannot be solved.
    bool failed() const { return m_undecided; }
    /// Returns the number of searches for events, and of points evaluated, since begin().
    SearchCount searchCount() const { return m_count; }
    void stall() const {}
    /// Does nothing: a power series can follow a line of the law with any slope.
    void turnTo(Real) const {}
    /// Returns the contact force that is small enough to be ignored, in units of F0.
    Real negligibleForce() const { return m_negligible; }
    /// Returns the error of the momentum of the rod by rounding and by joined pieces, in units of I0.
    Real momentumNoise() const { return 4 * std::numeric_limits<Real>::epsilon() + m_joiningError.bound(); }

    /// Returns a piece of a wave with the constant value `value` [F0] over `length` [t0].
    Piece constant(Real length, Real value) const {
        Piece f = Piece::zero(length);
        f.count = 1;
        f.c[0] = value;
        return f;
    }

    /// Returns the length of the hammer force that one series can hold, at most `left`, in units of t0.
    Real hammerPieceLength(const PulseSegment& segment, Real left) const {
        switch (segment.kind) {
            case PulseSegment::Kind::linear:
                return left;
            case PulseSegment::Kind::sine:
                return std::min(left, longestSine);
            case PulseSegment::Kind::exponential:
                return std::min(left, longestDecay);
        }
        return left;
    }

    /// Returns the hammer force over `length` as a power series. The force starts at the time `into` within
    /// its segment, in units of t0.
    const Piece& hammerPiece(const PulseSegment& segment, Real into, Real length) {
        m_hammer = Piece::zero(length);
        auto& c = m_hammer.c;
        switch (segment.kind) {
            case PulseSegment::Kind::linear:
                c[0] = Real(segment.value) + Real(segment.slope) * into;
                c[1] = Real(segment.slope) * length;
                m_hammer.count = c[1] == 0 ? 1 : 2;
                break;
            case PulseSegment::Kind::sine: {
                const Real pi = Real(3.14159265358979323846264338327950288L);
                const Real phase = pi * (Real(segment.start) + into);
                Real power = Real(segment.value);
                const Real sine = std::sin(phase), cosine = std::cos(phase);
                for (int k = 0; k < Piece::capacity; ++k) {
                    c[k] = power * (k % 4 == 0 ? sine : k % 4 == 1 ? cosine : k % 4 == 2 ? -sine : -cosine);
                    power *= pi * length / Real(k + 1);
                }
                m_hammer.count = Piece::capacity;
                break;
            }
            case PulseSegment::Kind::exponential: {
                Real power = Real(segment.value) * std::exp(-into);
                for (int k = 0; k < Piece::capacity; ++k) {
                    c[k] = power;
                    power *= -length / Real(k + 1);
                }
                m_hammer.count = Piece::capacity;
                break;
            }
        }
        m_hammer.trim(m_negligible);
        return m_hammer;
    }

    /// Adds the hammer force over `length` to the wave g, on the scale of `length`. The force starts at the
    /// time `into` within its segment, in units of t0.
    void addHammer(const PulseSegment& segment, Real into, Real length, Piece& g) {
        const Piece& hammer = hammerPiece(segment, into, length);
        if (g.scale != length) g.rescale(length);
        for (int k = g.count; k < hammer.count; ++k) g.c[k] = 0;
        g.count = std::max(g.count, hammer.count);
        for (int k = 0; k < hammer.count; ++k) g.c[k] += hammer.c[k];
        g.forgetWay();
    }

    /// Returns the integral of the hammer force Fa times the wave g over `length`. The force starts at the
    /// time `into` within its segment.
    Real hammerProduct(const PulseSegment& segment, Real into, const Piece& g, Real length) {
        const Piece& hammer = hammerPiece(segment, into, length);
        Piece scaled = g;
        scaled.rescale(hammer.scale);
        return Piece::productIntegral(hammer, scaled, length);
    }

    /// Returns the solution of F' = a(2g − F), F(0) = force, over as much of g as one piece can hold, with a
    /// = `rate` [paper (5)] [paper (8)]. It is inlined because it is needed for every piece of contact, and a
    /// call costs 3 %.
    [[gnu::always_inline]] Response& respond(const Piece& g, Real rate, Real force) {
        Response& r = m_response;
        r.incident = &g;
        r.isSlow = false;
        const Real alpha = rate * g.length;
        Real length = g.length;
        if (alpha > layer) {
            if (isStiff(alpha, g) && slowSolution(r, alpha, force)) return r;
            length = layerLength(g, rate, alpha);
        }
        for (;;) {
            takeFront(r, length);
            if (sumSeries(r, rate * length, force)) return r;
            length /= 2;
        }
    }

    const Piece& incidentOf(const Response& r) const { return *r.incident; }
    /// Writes the reflected wave g − F of the response to `reflected`. The caller cuts it at the end of the
    /// stretch of contact.
    void reflect(const Response& r, Piece& reflected) const {
        const Piece &g = *r.incident, &force = r.force;
        reflected.length = force.length;
        reflected.scale = force.scale;
        reflected.count = force.count;
        const int common = std::min(g.count, force.count);
        for (int k = 0; k < common; ++k) reflected.c[k] = g.c[k] - force.c[k];
        for (int k = common; k < force.count; ++k) reflected.c[k] = -force.c[k];
        reflected.displaceLike(g);
        reflected.forgetWay();
    }
    /// Returns the drive 2g − F of a response, which is the velocity U' of the bit and F'/a; valid until the
    /// next response.
    const Piece& drive(const Response& r) {
        const Piece &g = *r.incident, &force = r.force;
        Piece& d = m_drive;
        d.length = force.length;
        d.scale = force.scale;
        if (r.isSlow) {  // 2g and F nearly cancel
            d.count = std::max(force.count - 1, 0);
            for (int k = 0; k < d.count; ++k) d.c[k] = Real(k + 1) / r.alpha * force.c[k + 1];
            return d;
        }
        d.count = force.count;
        const int common = std::min(g.count, force.count);
        for (int k = 0; k < common; ++k) d.c[k] = 2 * g.c[k] - force.c[k];
        for (int k = common; k < force.count; ++k) d.c[k] = -force.c[k];
        return d;
    }
    /// Ends the stretch of contact at `length` [t0], and returns force, impulse and error there.
    StretchEnd<Real> endAt(Response& r, Real length) const {
        r.length = length;
        const Real size = r.size + r.incident->magnitude();
        return {r.force.value(length), r.force.integral(length),
                4 * (std::numeric_limits<Real>::epsilon() * size + m_negligible) * length};
    }
    /// Removes from the wave g the part that has arrived during the stretch of the response.
    void dropFront(Piece& g, const Response& r) const { g.dropFront(r.length); }

    /// Returns the time at which the incident wave g closes the gap (∫2g ds equals `gap`), if it does so
    /// within the piece.
    Zero<Real> gapClosure(const Piece& g, Real gap) {
        if (g.isZero()) return gap < 0 ? Zero<Real>::at(0) : Zero<Real>{};
        if (gap > 2 * g.way().most) return {};
        Real c[Piece::capacity + 1];
        c[0] = gap;
        for (int k = 0; k < g.count; ++k) c[k + 1] = -2 * g.scale * g.c[k] * Piece::inverse(k + 1);
        return scaled(firstZero(c, g.count + 1, g.length / g.scale, m_count), g.scale, g.length);
    }
    /// Returns the time at which the force falls to zero. F is a positive mean of 2g and of the earlier
    /// force, so a compressive wave cannot make it zero.
    Zero<Real> forceVanishes(const Response& r) {
        if (r.incident->isZero()) return {};
        const Real start = r.incident->startValue();
        if (start + start >= r.incident->magnitude()) return {};
        return zeroOf(r.force, r);
    }
    /// Returns the time within a stretch of contact at which the drive 2g − F changes from positive to
    /// negative.
    Zero<Real> driveVanishes(const Response& r) { return zeroOf(drive(r), r); }
    /// Returns the time at which F reaches `peak`. `tangential` is set at the start of unloading, where F =
    /// peak and F' = 0 exactly.
    Zero<Real> forceReaches(const Response& r, Real peak, bool tangential) {
        Real c[Piece::capacity];
        c[0] = tangential ? Real(0) : peak - r.force.startValue();
        Real rise = 0;
        for (int k = 1; k < r.force.count; ++k) {
            c[k] = -r.force.c[k];
            rise += std::abs(c[k]);
        }
        if (r.isSlow && c[0] <= 16 * (m_negligible + std::numeric_limits<Real>::epsilon() * peak))
            c[0] = 0;  // the slow solution differs from the force before by rounding
        else if (tangential && r.force.count > 1)
            c[1] = 0;
        if (c[0] > rise) return {};
        return scaled(firstZero(c, std::max(r.force.count, 1), r.length / r.force.scale, m_count),
                      r.force.scale, r.length);
    }

    /// Returns the larger of `before` and the largest force F of the response over [0, length]. The forces at
    /// both ends must be included in `before`.
    Real largest(const Response& r, Real length, Real before) {
        if (2 * r.incident->mostValue() <= before) return before;  // F ≤ max(F(0), 2 max g)
        Real most = before;
        m_undecided |=
            !forEachMaximum(drive(r), length, [&](Real x) { most = std::max(most, r.force.value(x)); });
        return most;
    }
    /// Returns the largest impulse ∫g over [0, x] for any x within the piece g, in units of I0; at least 0.
    Real largestIntegral(const Piece& g) {
        Real most = std::max(Real(0), g.integral(g.length));
        m_undecided |= !forEachMaximum(g, g.length, [&](Real x) { most = std::max(most, g.integral(x)); });
        return most;
    }

    /// Returns an upper bound of largestIntegral(g), in units of I0.
    Real mostIntegral(const Piece& g, Real, Real) const { return g.way().most; }
    /// Returns the impulse ∫g of a wave over the whole piece g, in units of I0.
    static Real impulse(const Piece& g) { return g.way().whole; }
    /// Returns the magnitude that, times the machine epsilon, estimates the rounding error of impulse().
    static Real impulseSize(const Piece& g) { return g.way().size; }

    /// Drops terms of the piece that are small enough to be ignored.
    void tidy(Piece& piece) const { piece.trim(m_negligible); }

    /// Joins the piece `next` to the piece `last` if that is accurate enough, and adds the effect on the
    /// coefficient of restitution to `error`. Returns whether the pieces were joined.
    bool join(Piece& last, const Piece& next, Real& error) { return m_joiner.join(last, next, error); }
    /// Adds the error that joined pieces cause during a stretch of the given length [t0] on the elastic line.
    void passElastic(Real length) { m_joiningError.passElastic(length); }
    /// Adds the error that joined pieces cause at a contact event, which ends the stretch at `length` [t0].
    /// `arriving` is the length of the arriving piece that has not passed yet.
    void passEvent(ContactEvent event, const Response& r, Real length, Real arriving) {
        m_joiningError.pass(event, length > 0 ? r.incident->displaced : r.incident->displacedAtStart,
                            arriving);
    }

    /// Returns the integral ∫f g ds over [0, length] of the product of two waves.
    static Real productIntegral(const Piece& f, const Piece& g, Real length) {
        return Piece::productIntegral(f, g, length);
    }

    /// Appends a stretch of time with incident wave and force to the histories of an impact; `force` is null
    /// without contact.
    void record(const Piece& incident, const Piece* force, Real length, Impact& impact) const {
        double c[Piece::capacity];
        const auto copy = [&](const Piece& f) {
            for (int k = 0; k < f.count; ++k) c[k] = double(f.c[k]);
            return std::span<const double>(c, static_cast<std::size_t>(f.count));
        };
        impact.incident.append(double(length), double(incident.scale), copy(incident));
        impact.force.append(double(length), double(incident.scale),
                            force ? copy(*force) : std::span<const double>());
    }

  private:
    /// Exponent of the power of two below which terms are dropped, relative to the largest wave force: 2^-10
    /// of a rounding error or less.
    static constexpr int negligibleExponent = std::numeric_limits<Real>::digits == 53 ? -62 : -80;
    /// Ratio of the largest acceptable last coefficient to m_negligible, the magnitude of dropped terms. It
    /// makes that coefficient as large as a rounding error.
    static constexpr Real seenByRounding = 1024;
    /// Largest sum of the absolute coefficients of a piece, relative to the wave force. With larger
    /// coefficients, the digits that they cancel would be lost.
    static constexpr Real mostCancellation = 256;

    // Limits of the length of a piece; longer pieces would need more coefficients than there are, or cancel.
    /// Longest piece of a half sine, in units of t0.
    static constexpr Real longestSine = 0.5;
    /// Longest piece of an exponential hammer force, in units of t0.
    static constexpr Real longestDecay = 2;
    /// Largest product aℓ of decay rate a and length ℓ for a piece of contact in which F still changes
    /// quickly; longer contact is split into several pieces.
    static constexpr Real layer = 2;
    /// Largest product aℓ of rate and length for a piece in which F is already near the slow solution; e^6
    /// cancels three digits of the small difference.
    static constexpr Real widestLayer = 6;
    static constexpr Real lastOrder = Piece::capacity - 2;

    /// Returns whether aℓ is so large that F may follow the slow solution 2g − F'/a. Each term of that series
    /// is then small compared with the one before: k/(aℓ) < 1/4 for all k up to the degree of g.
    static bool isStiff(Real alpha, const Piece& g) { return alpha >= Real(16 + 4 * g.count); }

    Zero<Real> scaled(Zero<Real> zero, Real scale, Real length) {
        m_undecided |= zero.undecided;
        zero.u = std::min(zero.u * scale, length);
        return zero;
    }
    Zero<Real> zeroOf(const Piece& f, const Response& r) {
        return scaled(firstZero(f.c.data(), f.count, r.length / f.scale, m_count), f.scale, r.length);
    }

    /// Sets the incident wave of the response to the first `length` [t0] of the arriving wave, on a scale of
    /// that length.
    void takeFront(Response& r, Real length) const {
        if (r.incident->scale == length) return;
        if (r.incident != &r.cut) r.cut = *r.incident;
        r.incident = &r.cut;
        r.cut.rescale(length);
        r.cut.trim(m_negligible);
        r.cut.length = length;
    }

    /// Computes the slow solution F = 2g − F'/a as an exact polynomial. Returns false if the force is not yet
    /// near enough to it.
    bool slowSolution(Response& r, Real alpha, Real force) {
        takeFront(r, r.incident->length);
        const Piece& g = *r.incident;
        r.force.scale = g.scale;
        r.force.count = g.count;
        Real next = 0;
        for (int k = g.count - 1; k >= 0; --k) {
            next = 2 * g.c[k] - (Real(k + 1) / alpha) * next;
            r.force.c[k] = next;
        }
        m_layer = std::abs(force - r.force.startValue());
        const Real rounding = 8 * std::numeric_limits<Real>::epsilon() * (std::abs(force) + g.magnitude());
        if (m_layer > 16 * m_negligible + rounding) return false;
        r.isSlow = true;
        r.alpha = alpha;
        r.size = g.magnitude() + r.force.magnitude();
        r.length = r.force.length = g.length;
        return true;
    }

    /// Returns the length to take of a long piece, in units of t0: aℓ = 2 in general, more if F is nearly the
    /// slow solution. The series may then neglect a larger share of the small difference, (aℓ)^n/n! with the
    /// last order n.
    Real layerLength(const Piece& g, Real rate, Real alpha) const {
        if (!isStiff(alpha, g)) return g.length / std::ceil(alpha / layer);
        const Real faint = std::max(m_layer / m_scale, std::numeric_limits<Real>::epsilon());
        const Real wide = layer * std::exp2(-std::log2(faint) / lastOrder);
        return std::min(g.length, std::clamp(wide, layer, widestLayer) / rate);
    }

    /// Computes the recurrence F_{k+1} = α (2g_k − F_k)/(k+1) for aℓ = `alpha`. Returns false if the series
    /// does not converge within its capacity.
    bool sumSeries(Response& r, Real alpha, Real force) {
        const Piece& g = *r.incident;
        r.length = r.force.length = r.force.scale = g.length;
        auto& f = r.force.c;
        f[0] = force;
        Real size = std::abs(force);
        int k = 0;
        for (; k < g.count; ++k) {
            if (k + 1 >= Piece::capacity) break;
            f[k + 1] = alpha * Piece::inverse(k + 1) * (2 * g.c[k] - f[k]);
            size += std::abs(f[k + 1]);
        }
        for (; std::abs(f[k]) > m_negligible && k + 1 < Piece::capacity; ++k) {
            f[k + 1] = -alpha * Piece::inverse(k + 1) * f[k];
            size += std::abs(f[k + 1]);
        }
        const bool full = k + 1 >= Piece::capacity;
        const Real gLast = k < g.count ? g.c[k] : Real(0);
        r.force.count = k + 1;
        r.size = size;
        const Real unresolved = seenByRounding * m_negligible;
        const bool converged = !full || (std::abs(f[k]) <= unresolved && std::abs(gLast) <= unresolved);
        return (converged && size <= mostCancellation * m_scale) || g.length * m_scale < m_negligible;
    }

    /// Whether a search for a contact event ended without a result.
    bool m_undecided = false;
    SearchCount m_count;
    /// Largest wave force of this blow, in units of F0; the scale for negligible terms.
    Real m_scale = 1;
    /// Magnitude up to which terms are dropped, in units of F0.
    Real m_negligible = 0;
    /// Distance of F from the slow solution 2g − F'/a, in units of F0.
    Real m_layer = 0;
    SeriesJoiner<Real> m_joiner;
    JoiningError<Real> m_joiningError;
    Piece m_hammer, m_drive;
    Response m_response;
};

}  // namespace drillwave
