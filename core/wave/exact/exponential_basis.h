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

/// Representation of the waves of ContactMarch by exponential sums (theory §3.2), for hammer forces of every
/// shape.
///
/// Each reflection in contact adds one term. Terms of other rates are divided by the differences of the
/// rates. Therefore the representation fails after some reflections, for lines of the law of nearly equal
/// slope, and for events that are tangential within rounding. The caller then uses power series.
///
/// `lines` is the number of lines of the law whose slopes are included: the first loading line, the elastic
/// line, and those after the first corners. The representation fails if the contact reaches any further line.
template <int lines>
class ExponentialBasis {
  public:
    using Real = double;
    using Piece = ExponentialSum<lines>;
    /// Type of sums of times and impulses; a plain number, because a blow has few pieces of waves.
    using Sum = double;
    /// Whether neighbouring pieces of waves are joined to save work; not needed, because exponential sums
    /// have few pieces.
    static constexpr bool joinsPieces = false;
    /// Rounding error of each term added to a Sum, relative to the sum.
    static constexpr double roundingOfSums = std::numeric_limits<double>::epsilon() / 2;

    /// Solution for one stretch of contact: the force as an exponential sum, and the arriving wave.
    struct Response {
        double length = 0;
        double rate = 0;
        /// Index of the line of the law on which the contact is, and whose slope is the rate of the response.
        int line = 0;
        /// Arriving wave g, which must outlive the response.
        const Piece* incident = nullptr;
        Piece force;
        /// Force at the start of the stretch, in units of F0.
        double start = 0;
        /// Impulse ∫g of the arriving wave over the stretch, in units of I0; set by endAt() if the wave has
        /// terms of ramps or curved hammer forces.
        double arrived = 0;
        /// Impulse ∫(g − F) of the reflected wave over the stretch, in units of I0; set by endAt() if the
        /// wave has terms of ramps or curved hammer forces.
        double left = 0;
        /// Magnitude of the terms that were dropped because they are below rounding, in units of F0.
        double dropped = 0;
        /// Whether drive() has been called for this response.
        bool hasDrive = false;
    };

    /// Prepares the representation for a blow with the given bit–rock law.
    void begin(const Problem& problem, const ContactLaw<double>& law);
    /// Returns whether this representation of waves has failed for the blow, so that power series must be
    /// used.
    bool failed() const { return m_failed; }
    /// Returns the number of searches for events, and of points evaluated, since begin().
    SearchCount searchCount() const { return m_count; }
    /// Makes this representation fail, because events repeat without progress in time.
    void stall() { m_failed = true; }
    /// Continues the contact on the loading line of slope `rate`; the representation fails if it has no such
    /// line.
    void turnTo(double rate) { m_failed |= lineOf(rate) == lines; }
    /// Returns the contact force that is small enough to be ignored, in units of F0.
    double negligibleForce() const { return m_negligible; }
    /// Returns the rounding error of the momentum of the rod, in units of I0.
    double momentumNoise() const { return 4 * std::numeric_limits<double>::epsilon(); }
    /// Returns a piece of a wave with the constant value `value` [F0] over `length` [t0].
    Piece constant(double length, double value) const;
    /// Returns the length of the hammer force that one piece can represent, in units of t0: always `left`,
    /// the rest of the segment.
    double hammerPieceLength(const PulseSegment&, double left) const { return left; }
    /// Adds the hammer force to the wave g over `length`. The force starts at the time `into` within its
    /// segment, in units of t0.
    void addHammer(const PulseSegment& segment, double into, double length, Piece& g) const;
    /// Returns the integral ∫Fa g ds of hammer force times wave over `length`. The force starts at the time
    /// `into` within its segment.
    double hammerProduct(const PulseSegment& segment, double into, const Piece& g, double length) const;

    /// Returns the contact force F with F' = a(2g − F), F(0) = force, over the piece g of the arriving wave,
    /// with a = `rate` [paper (5)] [paper (8)].
    Response& respond(Piece& g, double rate, double force);
    /// Returns the arriving wave g of a response.
    const Piece& incidentOf(const Response& r) const { return *r.incident; }
    /// Writes the reflected wave g − F of the response to `reflected`. The caller cuts it at the end of the
    /// stretch of contact.
    void reflect(const Response& r, Piece& reflected) const;
    /// Returns the drive 2g − F of a response, which is the velocity U' of the bit and F'/a; valid until the
    /// next response.
    const Piece& drive(Response& r);
    /// Ends the stretch at `length`, and returns force, impulse and error there. The decays computed for it
    /// are used for all functions of the stretch.
    StretchEnd<double> endAt(Response& r, double length) const;
    /// Removes from the wave g the part that has arrived during the stretch of the response.
    void dropFront(Piece& g, const Response& r) const {
        g.rates = &m_rates;
        const double rest = g.isCurved ? g.curve.impulse - r.arrived : 0;
        g.dropFront(r.length, r.force.wholeDecays);
        if (g.isCurved) [[unlikely]]
            g.curve.impulse = rest;
    }
    /// Returns the time at which the incident wave g closes the gap (∫2g equals the gap), if it does so
    /// within the piece.
    Zero<double> gapClosure(const Piece& g, double gap);
    /// Returns the time within a stretch of contact at which the force F falls to zero.
    Zero<double> forceVanishes(Response& r);
    /// Returns the time within a stretch of contact at which the drive 2g − F changes from positive to
    /// negative.
    Zero<double> driveVanishes(Response& r);
    /// Returns the time at which the force of a response reaches `peak`. `tangential` is set at the start of
    /// unloading, where F = peak and F' = 0 exactly.
    Zero<double> forceReaches(Response& r, double peak, bool tangential);
    /// Returns the largest impulse ∫g over [0, x] for any x within the piece g, in units of I0; at least 0.
    double largestIntegral(const Piece& g);
    /// Returns an upper bound of largestIntegral(), given `whole`, the integral over the whole piece. A bound
    /// that does not exceed `enough` is not made narrower.
    double mostIntegral(const Piece& g, double whole, double enough) const {
        const double most = g.mostIntegral();
        return most <= enough || g.hasSine() ? most : std::min(most, mostIntegralByEnds(g, whole));
    }
    /// Returns the impulse ∫g of a wave over the whole piece g, in units of I0.
    static double impulse(const Piece& g) { return g.impulse(); }
    /// Returns the magnitude that, times the machine epsilon, estimates the rounding error of impulse().
    static double impulseSize(const Piece& g) { return g.integralOfSizes(); }
    /// Drops terms of the piece that are small enough to be ignored.
    void tidy(Piece& piece) const {
        piece.rates = &m_rates;
        piece.trim(m_negligible);
    }

    /// Returns the larger of `before` and the largest force F of the response over [0, length]. The forces at
    /// both ends must be included in `before`.
    double largest(Response& r, double length, double before);
    /// Returns the integral ∫f g ds over [0, length] of the product of two waves.
    [[gnu::cold]] double productIntegral(const Piece& f, const Piece& g, double length) const;
    /// Appends a stretch of time with incident wave and force to the histories of an impact; `force` is null
    /// without contact.
    [[gnu::cold]] void record(const Piece& incident, const Piece* force, double length, Impact& impact) const;

  private:
    /// Indices in the list of rates: the first loading line and the elastic line of the law.
    static constexpr int primary = 0, elastic = 1;

    /// Returns `zero` unchanged; if the search for it was undecided, the representation fails.
    Zero<double> decided(Zero<double> zero) {
        m_failed |= zero.undecided;
        return zero;
    }

    using Curve = CurvedTerms<lines>;

    /// Returns the index of the first line of the law with the slope `rate`, or `lines` if there is none.
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
