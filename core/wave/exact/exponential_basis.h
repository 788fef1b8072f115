// SPDX-License-Identifier: GPL-3.0-or-later
// Contact solved in closed form, one piece from front to front however long: fast where reflections are few.
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

/// Represents waves of ContactMarch by exponential sums (theory §3.2), for pulses of every shape.
///
/// One term is added at each reflection in contact, and terms of other rates are divided by the differences
/// of the rates; so it fails(), and the caller turns to power series, after a few reflections, for lines
/// nearly as steep as another, and where an event is tangential within rounding.
///
/// `lines` counts the lines of the law whose slopes it has: the first loading line, the elastic one, and
/// those after the first corners. It fails where the contact reaches a line beyond them.
template <int lines>
class ExponentialBasis {
  public:
    using Real = double;
    using Piece = ExponentialSum<lines>;
    using Sum = double;                         ///< its pieces are few
    static constexpr bool joinsPieces = false;  ///< there are few
    /// Error of each term added to a Sum, relative to the sum.
    static constexpr double roundingOfSums = std::numeric_limits<double>::epsilon() / 2;

    struct Response {
        double length = 0;
        double rate = 0;
        int line = 0;                     ///< line with that rate
        const Piece* incident = nullptr;  ///< the arriving wave, which must outlive the response
        Piece force;
        double start = 0;       ///< the force at the start
        double arrived = 0;     ///< ∫g up to its end, by endAt() of curved forces
        double left = 0;        ///< ∫(g − F) up to its end, by endAt() of curved forces
        double dropped = 0;     ///< rounding that has been left out of it
        bool hasDrive = false;  ///< drive() has been called
    };

    void begin(const Problem& problem, const ContactLaw<double>& law);
    bool failed() const { return m_failed; }
    /// The searches for events since begin().
    SearchCount searchCount() const { return m_count; }
    /// Events that repeat without progress in time hang on rounding here.
    void stall() { m_failed = true; }
    /// Continues the contact along a line of that slope.
    void turnTo(double rate) { m_failed |= lineOf(rate) == lines; }
    double negligibleForce() const { return m_negligible; }
    double momentumNoise() const { return 4 * std::numeric_limits<double>::epsilon(); }
    Piece constant(double length, double value) const;
    double hammerPieceLength(const PulseSegment&, double left) const { return left; }
    void addHammer(const PulseSegment& segment, double into, double length, Piece& g) const;
    /// ∫Fa g over `length`, Fa counted from `into` the segment.
    double hammerProduct(const PulseSegment& segment, double into, const Piece& g, double length) const;

    /// Solves F' = a(2g − F), F(0) = force, over g [paper (5)] [paper (8)].
    Response& respond(Piece& g, double rate, double force);
    const Piece& incidentOf(const Response& r) const { return *r.incident; }
    /// Writes the wave g − F that runs back, to be cut at the end of the stretch.
    void reflect(const Response& r, Piece& reflected) const;
    /// The drive 2g − F = U' = F'/a of a response, until the next.
    const Piece& drive(Response& r);
    /// Ends the stretch. The decays up to there serve every function of it.
    StretchEnd<double> endAt(Response& r, double length) const;
    void dropFront(Piece& g, const Response& r) const {
        g.rates = &m_rates;
        const double rest = g.isCurved ? g.curve.impulse - r.arrived : 0;
        g.dropFront(r.length, r.force.wholeDecays);
        if (g.isCurved) [[unlikely]]
            g.curve.impulse = rest;
    }
    Zero<double> gapClosure(const Piece& g, double gap);
    Zero<double> forceVanishes(Response& r);
    Zero<double> driveVanishes(Response& r);
    Zero<double> forceReaches(Response& r, double peak, bool tangential);
    double largestIntegral(const Piece& g);
    /// An upper bound of that, and of 0, where that over the whole of g is known; one that is `enough` is not
    /// made narrower.
    double mostIntegral(const Piece& g, double whole, double enough) const {
        const double most = g.mostIntegral();
        return most <= enough || g.hasSine() ? most : std::min(most, mostIntegralByEnds(g, whole));
    }
    /// ∫g over the piece.
    static double impulse(const Piece& g) { return g.impulse(); }
    /// Returns the size that the rounding of impulse() is relative to.
    static double impulseSize(const Piece& g) { return g.integralOfSizes(); }
    void tidy(Piece& piece) const {
        piece.rates = &m_rates;
        piece.trim(m_negligible);
    }

    /// Returns the largest F over [0, length], or the largest before if that is not exceeded; F at the ends
    /// must be among those before.
    double largest(Response& r, double length, double before);
    [[gnu::cold]] double productIntegral(const Piece& f, const Piece& g, double length) const;
    [[gnu::cold]] void record(const Piece& incident, const Piece* force, double length, Impact& impact) const;

  private:
    static constexpr int primary = 0, elastic = 1;  ///< lines

    /// The zero, unless the search was undecided: then failed().
    Zero<double> decided(Zero<double> zero) {
        m_failed |= zero.undecided;
        return zero;
    }

    using Curve = CurvedTerms<lines>;

    /// The first line of that slope; `lines` where there is none.
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
