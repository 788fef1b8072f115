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

/// Representation of the waves of ContactMarch by truncated power series on short pieces.
///
/// For a piece of contact with rate a and length ℓ, F' = a(2g − F) is solved by a recurrence for the
/// coefficients of F if aℓ ≲ 2. If aℓ is larger, the piece is divided, unless F follows the slow solution F =
/// 2g − F'/a. For a polynomial g that is an exact polynomial, so one piece is enough, however large a is.
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

    /// Solution of F' = a(2g − F) over one stretch of contact: the arriving wave g and the impact force F as
    /// power series on the same scale.
    struct Response {
        /// Length of the stretch of contact, in units of t0.
        Real length = 0;
        /// Arriving wave g, which must outlive the response; it may point to `cut`.
        const Piece* incident = nullptr;
        /// First part of the arriving wave, as a power series whose scale is the length of this part;
        /// `incident` may point to it.
        Piece cut;
        /// Impact force F over the stretch, in units of F0.
        Piece force;
        /// Product aℓ of the contact's rate a and the length ℓ of the stretch.
        Real alpha = 0;
        /// Whether F is the slow solution 2g − F'/a, without the initial layer in which F approaches it. F'
        /// then cannot be computed from 2g − F, a difference of nearly equal numbers.
        bool isSlow = false;
        /// Sum of the absolute coefficients of the solved power series, in units of F0; times the machine
        /// epsilon, it estimates the rounding error.
        Real size = 0;
    };

    /// Prepares this representation of waves for a blow with the given bit–rock law.
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

    /// Returns whether a search for a contact event has failed; the blow then cannot be solved.
    bool failed() const { return m_undecided; }
    /// Returns the number of searches for contact events since begin(), and of points evaluated in them.
    SearchCount searchCount() const { return m_count; }
    void stall() const {}
    /// Does nothing: unlike exponential sums, a power series can follow a line of the bit–rock law with any
    /// slope.
    void turnTo(Real) const {}
    /// Returns the largest contact force that counts as zero, in units of F0.
    Real negligibleForce() const { return m_negligible; }
    /// Returns the estimated error of the rod's momentum due to rounding and to joined pieces of the wave, in
    /// units of I0.
    Real momentumNoise() const { return 4 * std::numeric_limits<Real>::epsilon() + m_joiningError.bound(); }

    /// Returns a piece of a wave with the constant value `value` [F0] over `length` [t0].
    Piece constant(Real length, Real value) const {
        Piece f = Piece::zero(length);
        f.count = 1;
        f.c[0] = value;
        return f;
    }

    /// Returns the length of hammer force that one power series can represent, in units of t0. It is at most
    /// `left`, the rest of the segment of the hammer force.
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

    /// Returns the hammer force over `length` [t0] as a power series. It is taken from the time `into` [t0]
    /// after the start of `segment`.
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

    /// Adds the hammer force over `length` [t0] to the wave `g`, as a power series in x/length. The force is
    /// taken from the time `into` [t0] after the start of `segment`.
    void addHammer(const PulseSegment& segment, Real into, Real length, Piece& g) {
        const Piece& hammer = hammerPiece(segment, into, length);
        if (g.scale != length) g.rescale(length);
        for (int k = g.count; k < hammer.count; ++k) g.c[k] = 0;
        g.count = std::max(g.count, hammer.count);
        for (int k = 0; k < hammer.count; ++k) g.c[k] += hammer.c[k];
        g.forgetWay();
    }

    /// Returns ∫Fa g ds over `length` [t0], the integral of hammer force times wave. The hammer force is
    /// taken from the time `into` [t0] after the start of `segment`.
    Real hammerProduct(const PulseSegment& segment, Real into, const Piece& g, Real length) {
        const Piece& hammer = hammerPiece(segment, into, length);
        Piece scaled = g;
        scaled.rescale(hammer.scale);
        return Piece::productIntegral(hammer, scaled, length);
    }

    /// Returns the solution of F' = a(2g − F), F(0) = force, with a = `rate` [paper (5)] [paper (8)]. It
    /// covers as much of the arriving wave g as one power series can follow. It is inlined because it is
    /// needed for every piece of contact, and a call costs 3 %.
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
    /// Writes the reflected wave g − F of a stretch of contact to `reflected`. The caller must shorten it to
    /// the length of the stretch.
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
    /// Returns the drive 2g − F over a stretch of contact: the velocity U' of the bit, equal to F'/a. Loading
    /// ends where it becomes negative. The reference is valid until the next stretch is solved.
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
    /// Ends the stretch of contact at `length` [t0]. Returns the force there, and the impulse over the
    /// stretch with its error.
    StretchEnd<Real> endAt(Response& r, Real length) const {
        r.length = length;
        const Real size = r.size + r.incident->magnitude();
        return {r.force.value(length), r.force.integral(length),
                4 * (std::numeric_limits<Real>::epsilon() * size + m_negligible) * length};
    }
    /// Removes from the arriving wave `g` the part that has passed during the stretch of contact `r`.
    void dropFront(Piece& g, const Response& r) const { g.dropFront(r.length); }

    /// Returns the time [t0] within the piece g of the incident wave at which the bit reaches the rock (∫2g
    /// ds = `gap`), if it does.
    Zero<Real> gapClosure(const Piece& g, Real gap) {
        if (g.isZero()) return gap < 0 ? Zero<Real>::at(0) : Zero<Real>{};
        if (gap > 2 * g.way().most) return {};
        Real c[Piece::capacity + 1];
        c[0] = gap;
        for (int k = 0; k < g.count; ++k) c[k + 1] = -2 * g.scale * g.c[k] * Piece::inverse(k + 1);
        return scaled(firstZero(c, g.count + 1, g.length / g.scale, m_count), g.scale, g.length);
    }
    /// Returns the time [t0] within the stretch at which the impact force F falls to zero, if it does. A
    /// compressive arriving wave cannot make it zero.
    Zero<Real> forceVanishes(const Response& r) {
        if (r.incident->isZero()) return {};
        const Real start = r.incident->startValue();
        if (start + start >= r.incident->magnitude()) return {};
        return zeroOf(r.force, r);
    }
    /// Returns the time [t0] within a stretch of contact at which the drive 2g − F changes from positive to
    /// negative, if it does. The force then has a maximum.
    Zero<Real> driveVanishes(const Response& r) { return zeroOf(drive(r), r); }
    /// Returns the time [t0] within the stretch at which the impact force F rises to `peak` [F0], if it does.
    /// `tangential` is set just after unloading began, where F = peak and F' = 0 exactly; rounding there is
    /// then ignored.
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

    /// Returns the largest impact force F over [0, length] of a stretch of contact, or `before` if that is
    /// larger. `before` must be at least the force at both ends.
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

    /// Returns an upper bound of the impulse ∫g over [0, x] for every x within the piece g, in units of I0;
    /// at least 0.
    Real mostIntegral(const Piece& g, Real, Real) const { return g.way().most; }
    /// Returns the impulse ∫g of a wave over the whole piece g, in units of I0.
    static Real impulse(const Piece& g) { return g.way().whole; }
    /// Returns an upper bound of ∫|g| over the piece g, in units of I0. Times the machine epsilon, it
    /// estimates the rounding error of impulse().
    static Real impulseSize(const Piece& g) { return g.way().size; }

    /// Drops terms of a wave piece that are negligible relative to the largest wave force.
    void tidy(Piece& piece) const { piece.trim(m_negligible); }

    /// Replaces two neighbouring pieces of the wave by one power series in `last`, if that is accurate
    /// enough, and adds the error of the coefficient of restitution to `error`. Otherwise returns false and
    /// changes nothing.
    bool join(Piece& last, const Piece& next, Real& error) { return m_joiner.join(last, next, error); }
    /// Adds the error of the rock's impulse due to joined pieces of the wave, for a contact that stays on the
    /// elastic line (unloading or reloading) for `length` [t0].
    void passElastic(Real length) { m_joiningError.passElastic(length); }
    /// Adds the error that joined pieces of the wave cause at a contact event. The event ends the stretch of
    /// contact at `length` [t0]. `arriving` is the length of the wave piece that was still to arrive when the
    /// stretch began [t0].
    void passEvent(ContactEvent event, const Response& r, Real length, Real arriving) {
        m_joiningError.pass(event, length > 0 ? r.incident->displaced : r.incident->displacedAtStart,
                            arriving);
    }

    /// Returns the integral ∫f g ds over [0, length] of the product of two waves.
    static Real productIntegral(const Piece& f, const Piece& g, Real length) {
        return Piece::productIntegral(f, g, length);
    }

    /// Appends the incident wave and the impact force over `length` [t0] to the histories in `impact`.
    /// `force` is null if bit and rock are apart.
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
    /// Exponent n of the limit below which terms are dropped: 2^n times the largest wave force. The limit is
    /// 2^-10 of a rounding error or less.
    static constexpr int negligibleExponent = std::numeric_limits<Real>::digits == 53 ? -62 : -80;
    /// Largest accepted last coefficient of a truncated power series, as a multiple of m_negligible. It is as
    /// small as a rounding error, so that the rest of the series may be neglected.
    static constexpr Real seenByRounding = 1024;
    /// Largest accepted sum of the absolute coefficients of a power series, relative to the largest wave
    /// force. Larger coefficients would cancel and lose too many digits.
    static constexpr Real mostCancellation = 256;

    // Limits of the length of a piece; longer pieces would need more coefficients than there are, or cancel.
    /// Longest part of a half-sine hammer force that one power series represents, in units of t0.
    static constexpr Real longestSine = 0.5;
    /// Longest part of an exponential hammer force that one power series represents, in units of t0.
    static constexpr Real longestDecay = 2;
    /// Largest product aℓ of decay rate a and length ℓ for a piece of contact in which F still changes
    /// quickly; longer contact is split into several pieces.
    static constexpr Real layer = 2;
    /// Largest product aℓ of rate and length for a piece in which F is already near the slow solution 2g −
    /// F'/a. With aℓ = 6, cancellation costs about three digits (e^6) of the small difference from it.
    static constexpr Real widestLayer = 6;
    static constexpr Real lastOrder = Piece::capacity - 2;

    /// Returns whether aℓ is so large that F may follow the slow solution 2g − F'/a for the polynomial g. In
    /// its expansion by powers of 1/a, each term is then small compared with the one before: k/(aℓ) < 1/4 for
    /// all k up to the degree of g.
    static bool isStiff(Real alpha, const Piece& g) { return alpha >= Real(16 + 4 * g.count); }

    Zero<Real> scaled(Zero<Real> zero, Real scale, Real length) {
        m_undecided |= zero.undecided;
        zero.u = std::min(zero.u * scale, length);
        return zero;
    }
    Zero<Real> zeroOf(const Piece& f, const Response& r) {
        return scaled(firstZero(f.c.data(), f.count, r.length / f.scale, m_count), f.scale, r.length);
    }

    /// Replaces the arriving wave of the response by its first `length` [t0], as a power series in x/length.
    void takeFront(Response& r, Real length) const {
        if (r.incident->scale == length) return;
        if (r.incident != &r.cut) r.cut = *r.incident;
        r.incident = &r.cut;
        r.cut.rescale(length);
        r.cut.trim(m_negligible);
        r.cut.length = length;
    }

    /// Computes the slow solution F = 2g − F'/a of F' = a(2g − F), an exact polynomial. Returns false if
    /// `force`, the force at the start of the stretch, still differs from it.
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

    /// Returns the length of the first part of a long piece that one series can hold, in units of t0. In
    /// general aℓ = 2. It is up to aℓ = 6 if F is nearly the slow solution 2g − F'/a, because the series then
    /// represents only a small difference.
    Real layerLength(const Piece& g, Real rate, Real alpha) const {
        if (!isStiff(alpha, g)) return g.length / std::ceil(alpha / layer);
        const Real faint = std::max(m_layer / m_scale, std::numeric_limits<Real>::epsilon());
        const Real wide = layer * std::exp2(-std::log2(faint) / lastOrder);
        return std::min(g.length, std::clamp(wide, layer, widestLayer) / rate);
    }

    /// Computes the power series of F for F' = a(2g − F), F(0) = `force`, by F_{k+1} = α (2g_k − F_k)/(k+1)
    /// with α = aℓ. Returns false if it does not converge within its capacity, or if its terms cancel too
    /// many digits.
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

    /// Whether a search for a contact event gave up without a clear answer.
    bool m_undecided = false;
    SearchCount m_count;
    /// Largest wave force of this blow, in units of F0. Terms that are negligible relative to it are dropped.
    Real m_scale = 1;
    /// Magnitude up to which terms of a power series are dropped, in units of F0.
    Real m_negligible = 0;
    /// Difference between the force at the start of a stretch of contact and the slow solution 2g − F'/a, in
    /// units of F0.
    Real m_layer = 0;
    SeriesJoiner<Real> m_joiner;
    JoiningError<Real> m_joiningError;
    Piece m_hammer, m_drive;
    Response m_response;
};

}  // namespace drillwave
