// SPDX-License-Identifier: GPL-3.0-or-later
// Contact solved with exponential sums, one piece from one wave front to the next, however long: fast if
// reflections are few.
#pragma once

#include <algorithm>
#include <limits>

#include "core/contact/contact_law.h"
#include "core/wave/exact/exponential_course.h"
#include "core/wave/exact/exponential_sum.h"
#include "core/wave/exact/exponential_zero.h"
#include "core/wave/exact/stretch_end.h"
#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Representation of waves by exponential sums for ContactMarch (theory §3.2), for hammer forces of every
/// shape.
///
/// A sum has room for few terms, and each reflection in contact adds one. Coefficients are divided by
/// differences of the rates, so nearly equal slopes of the bit–rock law lose accuracy. If terms or accuracy
/// do not suffice, or if rounding hides an event, failed() becomes true. The caller then uses power series.
///
/// `lines` is the number of lines of the bit–rock law whose slopes can be rates of the terms. They are the
/// first loading line, the elastic line, and those after the first corners. The representation fails if the
/// contact reaches any further line.
template <int lines>
class ExponentialBasis {
  public:
    using Real = double;
    using Piece = ExponentialSum<lines>;
    /// Type of accumulated times and impulses. A plain number is accurate enough, because a blow has few
    /// pieces of waves.
    using Sum = double;
    /// Whether neighbouring pieces of waves are joined to save work; not needed, because exponential sums
    /// have few pieces.
    static constexpr bool joinsPieces = false;
    /// Rounding error of each time or impulse added to a Sum, relative to the sum.
    static constexpr double roundingOfSums = std::numeric_limits<double>::epsilon() / 2;

    /// Solution of F' = a(2g − F) over one stretch of contact: the impact force F as an exponential sum, and
    /// the arriving wave g.
    struct Response {
        double length = 0;
        double rate = 0;
        /// Index of the line of the bit–rock law on which the contact is; its slope is the rate of the
        /// response.
        int line = 0;
        /// Arriving wave g, which must outlive the response.
        const Piece* incident = nullptr;
        Piece force;
        /// Impact force F at the start of the stretch, in units of F0.
        double start = 0;
        /// Impulse ∫g of the arriving wave over this stretch of contact, in units of I0. endAt() sets it only
        /// for waves with terms of sloped or curved hammer forces.
        double arrived = 0;
        /// Impulse ∫(g − F) of the reflected wave over this stretch of contact, in units of I0. endAt() sets
        /// it only for waves with terms of sloped or curved hammer forces.
        double left = 0;
        /// Magnitude of the terms that were dropped because they are below rounding, in units of F0.
        double dropped = 0;
        /// Whether drive() has already computed 2g − F for this response.
        bool hasDrive = false;
    };

    /// Prepares this representation of waves for a blow with the given bit–rock law.
    void begin(const Problem& problem, const ContactLaw<double>& law);
    /// Returns whether this representation of waves has failed for the blow, so that power series must be
    /// used.
    bool failed() const { return m_failed; }
    /// Returns the number of searches for contact events since begin(), and of points evaluated in them.
    SearchCount searchCount() const { return m_count; }
    /// Makes this representation fail, because contact events repeat without progress in time. The caller
    /// then uses power series.
    void stall() { m_failed = true; }
    /// Prepares for contact on the loading line of slope `rate` of the bit–rock law, after a corner. If the
    /// sums have no terms for this slope, failed() becomes true.
    void turnTo(double rate) { m_failed |= lineOf(rate) == lines; }
    /// Returns the largest contact force that counts as zero, in units of F0.
    double negligibleForce() const { return m_negligible; }
    /// Returns the estimated rounding error of the rod's momentum, in units of I0.
    double momentumNoise() const { return 4 * std::numeric_limits<double>::epsilon(); }
    /// Returns a piece of a wave with the constant value `value` [F0] over `length` [t0].
    Piece constant(double length, double value) const;
    /// Returns the length of hammer force that one piece of the wave can represent, in units of t0. It is
    /// always `left`, the rest of the segment of the hammer force.
    double hammerPieceLength(const PulseSegment&, double left) const { return left; }
    /// Adds the hammer force over `length` [t0] to the wave `g`. The force is taken from the time `into` [t0]
    /// after the start of `segment`.
    void addHammer(const PulseSegment& segment, double into, double length, Piece& g) const;
    /// Returns the integral ∫Fa g ds of hammer force times wave over `length` [t0]. The hammer force is taken
    /// from the time `into` [t0] after the start of `segment`.
    double hammerProduct(const PulseSegment& segment, double into, const Piece& g, double length) const;

    /// Solves F' = a(2g − F), F(0) = force, with a = `rate`, over the piece g of the arriving wave, and
    /// returns the contact force F [paper (5)] [paper (8)].
    Response& respond(Piece& g, double rate, double force);
    /// Returns the arriving wave g of a solved stretch of contact.
    const Piece& incidentOf(const Response& r) const { return *r.incident; }
    /// Writes the reflected wave g − F of a stretch of contact to `reflected`. The caller must shorten it to
    /// the length of the stretch.
    void reflect(const Response& r, Piece& reflected) const;
    /// Returns the drive 2g − F over a stretch of contact: the velocity U' of the bit, equal to F'/a. Loading
    /// ends where it becomes negative. The reference is valid until the next stretch is solved.
    const Piece& drive(Response& r);
    /// Ends the stretch of contact at `length` [t0]. Returns the force there, and the impulse over the
    /// stretch with its error. The decays e^(−λ·length) computed for it are kept for all functions of the
    /// stretch.
    StretchEnd<double> endAt(Response& r, double length) const;
    /// Removes from the arriving wave `g` the part that has passed during the stretch of contact `r`.
    void dropFront(Piece& g, const Response& r) const {
        g.rates = &m_rates;
        const double rest = g.isCurved ? g.curve.impulse - r.arrived : 0;
        g.dropFront(r.length, r.force.wholeDecays);
        if (g.isCurved) [[unlikely]]
            g.curve.impulse = rest;
    }
    /// Returns the time [t0] within the piece g of the incident wave at which the bit reaches the rock (∫2g
    /// ds = `gap`), if it does.
    Zero<double> gapClosure(const Piece& g, double gap);
    /// Returns the time [t0] within the stretch at which the impact force F falls to zero, if it does.
    Zero<double> forceVanishes(Response& r);
    /// Returns the time [t0] within a stretch of contact at which the drive 2g − F changes from positive to
    /// negative, if it does. The force then has a maximum.
    Zero<double> driveVanishes(Response& r);
    /// Returns the time [t0] within the stretch at which the impact force F rises to `peak` [F0], if it does.
    /// `tangential` is set just after unloading began, where F = peak and F' = 0 exactly; rounding there is
    /// then ignored.
    Zero<double> forceReaches(Response& r, double peak, bool tangential);
    /// Returns the largest impulse ∫g over [0, x] for any x within the piece g, in units of I0; at least 0.
    double largestIntegral(const Piece& g);
    /// Returns an upper bound of the impulse ∫g over [0, x] for every x within the piece g, in units of I0.
    /// `whole` is ∫g over the whole piece. If a quickly computed bound exceeds `enough`, a closer one is also
    /// computed.
    double mostIntegral(const Piece& g, double whole, double enough) const {
        const double most = g.mostIntegral();
        return most <= enough || g.hasSine() ? most : std::min(most, mostIntegralByEnds(g, whole));
    }
    /// Returns the impulse ∫g of a wave over the whole piece g, in units of I0.
    static double impulse(const Piece& g) { return g.impulse(); }
    /// Returns an upper bound of the integral of the absolute values of all terms of g, in units of I0. Times
    /// the machine epsilon, it estimates the rounding error of impulse().
    static double impulseSize(const Piece& g) { return g.integralOfSizes(); }
    /// Drops terms of a wave piece that are negligible relative to the largest wave force.
    void tidy(Piece& piece) const {
        piece.rates = &m_rates;
        piece.trim(m_negligible);
    }

    /// Returns the largest impact force F over [0, length] of a stretch of contact, or `before` if that is
    /// larger. `before` must be at least the force at both ends.
    double largest(Response& r, double length, double before);
    /// Returns the integral ∫f g ds over [0, length] of the product of two waves.
    [[gnu::cold]] double productIntegral(const Piece& f, const Piece& g, double length) const;
    /// Appends the incident wave and the impact force over `length` [t0] to the histories in `impact`.
    /// `force` is null if bit and rock are apart.
    [[gnu::cold]] void record(const Piece& incident, const Piece* force, double length, Impact& impact) const;

  private:
    /// Indices in m_rates: slope of the first loading line, and slope of the elastic line (unloading and
    /// reloading) of the bit–rock law.
    static constexpr int primary = 0, elastic = 1;

    /// Returns `zero` unchanged; if its search was undecided, failed() becomes true.
    Zero<double> decided(Zero<double> zero) {
        m_failed |= zero.undecided;
        return zero;
    }

    using Curve = CurvedTerms<lines>;

    /// Returns the index of the first line of the bit–rock law with the slope `rate`, or `lines` if there is
    /// none.
    int lineOf(double rate) const {
        int line = 0;
        while (line < lines && m_rates[line] != rate) ++line;
        return line;
    }
    bool respondToCurve(const Curve& g, int line, Curve& force) const;
    void shorten(Response& r, double length) const;
    Zero<double> searchedGapClosure(const Piece& g, double gap);

    LineRates<lines> m_rates{};
    double m_scale = 1;
    double m_negligible = 0;
    bool m_failed = false;
    SearchCount m_count;
    Piece m_drive, m_searched;
    Response m_response;
};

}  // namespace drillwave
