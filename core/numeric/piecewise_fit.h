// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth pieces of functions that are costly to evaluate and have kinks, to a known accuracy and with bounded
// work.
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

// A smooth function on an interval as a sum of Chebyshev polynomials through its values.

/// p(x) = Σ c_k T_k(u), u = (2x − a − b)/(b − a), on [a, b].
class Chebyshev {
  public:
    static constexpr std::size_t mostNodes = 17;

    Chebyshev() = default;
    /// Through `values` at node(a, b, j, values.size()); 2 to mostNodes of them.
    Chebyshev(double a, double b, std::span<const double> values);

    /// The j-th of `count` nodes in [a, b]: extrema of a Chebyshev polynomial, the first is a, the last b.
    /// Every second one of 17 is one of 9.
    static double node(double a, double b, std::size_t j, std::size_t count);

    double operator()(double x) const;
    double slope(double x) const;
    /// Size of the last coefficients: for a smooth function about the error of p.
    double tail() const;
    /// Returns where p' changes sign inside the interval, ascending.
    std::vector<double> stationaryPoints() const;

  private:
    double position(double x) const { return ((x - m_start) + (x - m_end)) / (m_end - m_start); }

    double m_start = 0;
    double m_end = 1;
    std::size_t m_count = 0;
    std::array<double, mostNodes> m_coefficients{};
    std::array<double, mostNodes> m_slopes{};  // coefficients of p'
};

/// Maximum number of functions that are fitted together, on the same pieces.
inline constexpr std::size_t mostFitFunctions = 3;

/// The functions at one place.
struct FitSample {
    double x = 0;
    std::array<double, mostFitFunctions> values{};
    double error = 0;         ///< bound on the error of the values
    std::uint64_t order = 0;  ///< the functions are smooth while it stays the same
    int label = 0;            ///< distinguishes pieces in any way the caller likes
    bool solved = false;      ///< false: no values here
    long effort = 0;          ///< cost, in the units of mostEffort and mostFailedEffort
};

/// A stretch over which all functions are smooth.
struct FitPiece {
    double start = 0;
    double end = 0;
    std::vector<Chebyshev> outputs;  ///< of the functions; empty where there is no answer
    std::vector<double> error;       ///< bound of |outputs − exact| as estimated, in units of the functions
    int label = 0;                   ///< that of a sample inside
    bool resolved = true;  ///< the error is within the tolerance; else this is a sliver around a kink,
                           ///< or more work than was permitted
    bool solved = true;    ///< false: no result here, and no numbers
};

/// Functions to fit, accuracy, and limits of the work.
struct FitSettings {
    std::size_t count = 1;  ///< of functions, 1 … mostFitFunctions
    /// Size that the tolerance is relative to, for each function.
    std::array<double, mostFitFunctions> scale{1, 1, 1};
    /// Whether larger values replace `scale` when seen.
    std::array<bool, mostFitFunctions> scaleGrows{};
    double tolerance = 1e-10;
    double kinkWidth = 1e-12;   ///< of the bracket around a change of the order
    double leastWidth = 1e-11;  ///< of a piece that is still halved
    // Limits on the work for functions that never become smooth, for each cell and what earlier cells left
    // over.
    std::uint64_t solvesOfCell = 2'000;
    std::uint64_t kinksOfCell = 100;
    std::uint64_t failuresOfCell = 20;  ///< places without values, not left over to later cells
    /// In all. Beyond, nothing is halved or bracketed any more: what is left is not resolved.
    long mostEffort = std::numeric_limits<long>::max();
    long mostFailedEffort = std::numeric_limits<long>::max();  ///< in all, of places without values
    /// Where values end: halved towards, as any rough place, or bracketed as a kink is.
    enum class Ends { halved, bracketed } ends = Ends::halved;
};

/// The functions from the first of the cuts to the last.
struct PiecewiseFit {
    std::vector<FitPiece> pieces;  ///< ascending, contiguous but for slivers of kinkWidth
    std::vector<double> borders;   ///< places at which the order changes
    std::uint64_t solves = 0;      ///< samples taken
    double largestError = 0;       ///< of the samples
    double unsolved = 0;           ///< length without values
};

/// Takes a sample at x. Results after a stop are not used.
using FitFunction = std::function<FitSample(double x)>;
/// Called from time to time with the x up to which there are pieces.
using FitProgress = std::function<void(double x)>;

/// Interpolates over the cells between ascending `cuts` (at least two). Pieces end where the order of samples
/// changes, found by bracketing, and are halved until polynomials through samples agree with others, to
/// `tolerance` of `scale` and eight times the error of samples. Stops early, incomplete, on the stop token.
PiecewiseFit fitPiecewise(const FitSettings& settings, std::span<const double> cuts,
                          const FitFunction& function, const std::stop_token& stop = {},
                          const FitProgress& progress = {});

/// Does the same for functions that do not depend on x: one sample, at `start`.
PiecewiseFit fitConstant(const FitSettings& settings, double start, double end, const FitFunction& function,
                         const std::stop_token& stop = {});

/// The piece to look up x in: the one that x is in, or before the first the first, or where there is no
/// answer the last before that has one. Requires a solved piece at or before x.
const FitPiece& pieceAt(std::span<const FitPiece> pieces, double x);

/// Places at which to draw: the ends of solved pieces, except very short ones, and no more than `farthest`
/// apart.
std::vector<double> samplePlaces(std::span<const FitPiece> pieces, double farthest);

}  // namespace drillwave
