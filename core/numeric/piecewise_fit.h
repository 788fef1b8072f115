// SPDX-License-Identifier: GPL-3.0-or-later
// Fit of smooth pieces to functions that are costly to evaluate and have kinks, with a known error and a
// limited number of evaluations.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <stop_token>
#include <vector>

namespace drillwave {

// Smooth function on an interval, interpolated by Chebyshev polynomials.

/// Polynomial p(x) = Σ c_k T_k(u) on [a, b], where T_k are Chebyshev polynomials of u = (2x − a − b)/(b − a).
class Chebyshev {
  public:
    static constexpr std::size_t mostNodes = 17;

    Chebyshev() = default;
    /// Makes the polynomial that takes `values` at the nodes node(a, b, j, n), j = 0 … n − 1. The number n of
    /// values is 2 … mostNodes.
    Chebyshev(double a, double b, std::span<const double> values);

    /// Returns the j-th of `count` nodes in [a, b], ascending from a to b, at the extremes of a Chebyshev
    /// polynomial. The nodes for a count of 9 are every second one for 17, so that samples can be used again.
    static double node(double a, double b, std::size_t j, std::size_t count);

    double operator()(double x) const;
    double slope(double x) const;
    /// Returns the largest absolute value among the last three coefficients c_k. For a smooth function this
    /// is about the error of the interpolation.
    double tail() const;
    /// Returns the points inside the interval at which the derivative of the polynomial changes sign,
    /// ascending.
    std::vector<double> stationaryPoints() const;

  private:
    double position(double x) const { return ((x - m_start) + (x - m_end)) / (m_end - m_start); }

    double m_start = 0;
    double m_end = 1;
    std::size_t m_count = 0;
    std::array<double, mostNodes> m_coefficients{};
    std::array<double, mostNodes> m_slopes{};  // Chebyshev coefficients of p'
};

/// Largest number of functions that are fitted together, on the same pieces.
inline constexpr std::size_t mostFitFunctions = 3;

/// Values at one x of all functions that are fitted together, and their error.
struct FitSample {
    double x = 0;
    std::array<double, mostFitFunctions> values{};
    double error = 0;  ///< bound on the absolute error of the values
    /// Number that shows where the kinks are: it is equal for all samples between two kinks, and different
    /// on the two sides of a kink.
    std::uint64_t order = 0;
    int label = 0;        ///< any number by which the caller distinguishes pieces
    bool solved = false;  ///< whether the functions have values at this x
    long effort = 0;      ///< cost of the evaluation, in the unit of mostEffort and mostFailedEffort
};

/// Interval over which all fitted functions are smooth.
struct FitPiece {
    double start = 0;
    double end = 0;
    /// Interpolating polynomial of each fitted function; empty if the functions have no values in this piece.
    std::vector<Chebyshev> outputs;
    std::vector<double> error;  ///< estimated bound of |output − exact value|, one for each function
    int label = 0;              ///< label of the sample nearest to the middle of the piece
    /// Whether the error of the interpolation in this piece is within the tolerance. It is false for a very
    /// short piece around a kink, or if the limit of work was reached.
    bool resolved = true;
    bool solved = true;  ///< whether the functions have values in this piece
};

/// Accuracy of a piecewise fit, number of functions, and limits on the work.
struct FitSettings {
    std::size_t count = 1;  ///< number of functions, 1 … mostFitFunctions
    /// Typical size of the values of each function. The allowed error of a function is `tolerance` times its
    /// size.
    std::array<double, mostFitFunctions> scale{1, 1, 1};
    /// Whether the member `scale` of a function is increased during the fit to the largest absolute value of
    /// the function found so far. If false, it remains as given.
    std::array<bool, mostFitFunctions> scaleGrows{};
    double tolerance = 1e-10;
    double kinkWidth = 1e-12;   ///< length of the bracket around a kink, in units of x
    double leastWidth = 1e-11;  ///< length below which a piece is not halved any more, in units of x
    // Limits on the work per interval between two cuts, for functions that never become smooth. Unused work
    // is available for later intervals.
    std::uint64_t solvesOfCell = 2'000;
    std::uint64_t kinksOfCell = 100;
    /// Maximum number of evaluations at which the functions have no values, in one interval between two
    /// cuts. After this number, the rest of the interval is left without values. Unused evaluations are not
    /// available for later intervals.
    std::uint64_t failuresOfCell = 20;
    /// Maximum work of the fit: total of FitSample::effort of all evaluations. After this maximum, pieces
    /// are no longer refined, and their FitPiece::resolved is false.
    long mostEffort = std::numeric_limits<long>::max();
    /// Maximum total of FitSample::effort of the evaluations at which the functions have no values. After
    /// this maximum, the remaining interval is left without values.
    long mostFailedEffort = std::numeric_limits<long>::max();
    /// Treatment of a point beyond which the functions have no values. `halved` halves the pieces next to
    /// this point until they are very short. `bracketed` finds the point by bisection, as for a kink.
    enum class Ends { halved, bracketed } ends = Ends::halved;
};

/// Result of fitPiecewise() over the interval from the first to the last of the given cuts.
struct PiecewiseFit {
    /// Pieces in ascending order of x without gaps between them. Around each kink there is a very short
    /// piece of length kinkWidth.
    std::vector<FitPiece> pieces;
    std::vector<double> borders;  ///< x of the kinks, where the order of the samples changes
    std::uint64_t solves = 0;     ///< number of evaluations of the functions
    double largestError = 0;      ///< largest error of a sample
    double unsolved = 0;          ///< total length, in units of x, over which there are no values
};

/// Function that evaluates the fitted functions and returns the sample at x. Results after a stop request are
/// not used.
using FitFunction = std::function<FitSample(double x)>;
/// Callback for progress: it is called during the fit with the x up to which all pieces are finished.
using FitProgress = std::function<void(double x)>;

/// Fits the functions over the interval between ascending `cuts`, at least two, and returns the pieces. A
/// piece ends at each kink, where FitSample::order changes; its x is found by bisection. Other pieces are
/// halved until the interpolation agrees with further samples. The error allowed is `tolerance` times `scale`
/// plus eight times the error of the samples. A stop request ends the fit early and incomplete.
PiecewiseFit fitPiecewise(const FitSettings& settings, std::span<const double> cuts,
                          const FitFunction& function, const std::stop_token& stop = {},
                          const FitProgress& progress = {});

/// Returns a fit of one piece for functions that do not depend on x, from a single sample at `start`.
PiecewiseFit fitConstant(const FitSettings& settings, double start, double end, const FitFunction& function,
                         const std::stop_token& stop = {});

/// Returns the piece of a fit with which to evaluate the functions at x. It is the piece that contains x, or
/// the first piece if x is before all pieces. If the functions have no values in it, it is the last earlier
/// piece that has values. Requires that there is such a piece.
const FitPiece& pieceAt(std::span<const FitPiece> pieces, double x);

/// Returns the abscissas x, ascending, of a polyline that draws the fit. They are the ends of all pieces in
/// which the functions have values, and points between them at most `farthest` apart. Points closer than
/// 1e-9 are merged.
std::vector<double> samplePlaces(std::span<const FitPiece> pieces, double farthest);

}  // namespace drillwave
