// SPDX-License-Identifier: GPL-3.0-or-later
// Contact solved in closed form, one piece from front to front however long: fast where reflections are few.
#pragma once

#include "core/wave/exact/exponential_sum.h"
#include "core/wave/exact/first_zero.h"
#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// The representation of ContactMarch by exponential sums, for pulses of constant or linear pieces.
///
/// One term is added at each reflection in contact, and terms of the other rate are divided by the difference
/// of the rates; so it fails(), and the caller turns to power series, after a few reflections, for γ near but
/// not at 1, and where an event is tangential within rounding.
class ExponentialBasis {
  public:
    using Real = double;
    using Piece = ExponentialSum;
    using Sum = double;                         ///< its pieces are few
    static constexpr bool joinsPieces = false;  ///< there are few

    struct Response {
        double length = 0;
        double rate = 0;
        Piece incident, force, reflected;
        double size = 0;
    };

    /// Whether it is worth trying: few reflections, rates apart, pulse of linear pieces.
    static bool suits(const Problem& problem);

    void begin(const Problem& problem, ContactRates<double> rates);
    bool failed() const { return m_failed; }
    /// The searches for events since begin().
    SearchCount searchCount() const { return m_count; }
    /// Events that repeat without progress in time hang on rounding here.
    void stall() { m_failed = true; }
    double negligibleForce() const { return m_negligible; }
    double momentumNoise() const { return 4 * std::numeric_limits<double>::epsilon(); }
    Piece constant(double length, double value) const;
    double hammerPieceLength(const PulseSegment&, double left) const { return left; }
    const Piece& addHammer(const PulseSegment& segment, double into, double length, Piece& g);

    /// Solves F' = a(2g − F), F(0) = force, over g [paper (5)] [paper (8)].
    Response& respond(const Piece& g, double rate, double force);
    /// The drive 2g − F = U' = F'/a of a response, until the next is asked for.
    const Piece& drive(const Response& r);
    void endAt(Response& r, double length);
    void dropFront(Piece& g, const Response& r) const;
    Zero<double> gapClosure(const Piece& g, double gap);
    Zero<double> forceVanishes(Response& r);
    Zero<double> driveVanishes(Response& r);
    Zero<double> forceReaches(Response& r, double peak, bool tangential);
    double largestIntegral(const Piece& g);
    double roundingError(const Response& r, double length) const;
    void tidy(Piece& piece) const;

    /// Largest F over [0, length].
    [[gnu::cold]] double largest(const Response& r, double length);
    [[gnu::cold]] double productIntegral(const Piece& f, const Piece& g, double length) const;
    [[gnu::cold]] void record(const Piece& incident, const Piece* force, double length, Impact& impact) const;

  private:
    /// A function at one point, with a lower bound of its curvature from there on.
    struct Sample {
        double value = 0, slope = 0, curvature = 0, leastCurvature = 0;
        double size = 0;     ///< what the rounding of `value` is relative to
        double fastest = 0;  ///< the largest rate in it
    };
    static constexpr int mostSteps = 200;

    Sample sample(const Piece& f, double c2, double x) const;
    Zero<double> firstZero(const Piece& f, double c2, double end, double start = 0, bool zeroAtStart = false);
    Zero<double> closeIn(const Piece& f, double c2, double x, Sample s, double end, double latest);

    ContactRates<double> m_rates;
    double m_scale = 1;
    double m_negligible = 0;
    bool m_failed = false;
    SearchCount m_count;
    Piece m_hammer, m_drive, m_searched;
    Response m_response;
};

}  // namespace drillwave
