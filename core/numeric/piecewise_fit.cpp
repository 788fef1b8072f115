// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/piecewise_fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "core/numeric/brent.h"

namespace drillwave {

namespace {

/// cos(π j/(2·16)), from which the cosines of all node counts are taken.
double cosine(std::size_t j, std::size_t of) {
    return std::cos(std::numbers::pi * static_cast<double>(j) / static_cast<double>(of));
}

/// Σ c_k T_k(u) by Clenshaw's recurrence.
double sum(std::span<const double> c, double u) {
    double b1 = 0, b2 = 0;
    for (std::size_t k = c.size(); k-- > 1;) {
        const double b0 = 2 * u * b1 - b2 + c[k];
        b2 = b1;
        b1 = b0;
    }
    return c.empty() ? 0 : u * b1 - b2 + c[0];
}

/// cos(π i/n) for i = 0 … 2n − 1.
const std::vector<double>& cosinesOf(std::size_t n) {
    static const auto tables = [] {
        std::array<std::vector<double>, Chebyshev::mostNodes> all;
        for (std::size_t of = 1; of < all.size(); ++of)
            for (std::size_t i = 0; i < 2 * of; ++i) all[of].push_back(cosine(i, of));
        return all;
    }();
    return tables[n];
}

constexpr std::size_t coarseNodes = 9;
constexpr std::size_t fineNodes = Chebyshev::mostNodes;  // every second one is a coarse node
constexpr std::size_t middleNode = fineNodes / 2;

using Nodes = std::array<FitSample, fineNodes>;
using Errors = std::array<double, mostFitFunctions>;

class Builder {
  public:
    Builder(const FitSettings& settings, const FitFunction& function, const std::stop_token& stop,
            const FitProgress& progress)
        : m_settings(settings),
          m_function(function),
          m_stop(stop),
          m_progress(progress),
          m_scale(settings.scale) {}

    PiecewiseFit build(std::span<const double> cuts);
    PiecewiseFit buildConstant(double start, double end);

  private:
    /// Properties of an interval found from its nodes.
    struct Finding {
        enum Kind {
            smooth,  ///< all nodes taken, and polynomials through them will do
            kink,    ///< at node `at` the order is another one
            rough,   ///< neither; the middle is taken, and the coarse nodes if the work limit is reached
        } kind;
        std::size_t at = 0;
        Errors errors{};
    };

    FitSample solve(double x);
    void refine(const FitSample& a, const FitSample& b);
    Finding probe(Nodes& nodes);
    bool agrees(const Nodes& nodes, Errors& errors);
    void bracketKink(const FitSample& first, const FitSample& last);
    void bracketEnd(const FitSample& first, const FitSample& last);
    void lookForValues(const FitSample& a, const FitSample& b);
    void accept(std::span<const FitSample> nodes, const Errors& errors);
    void acceptAsIs(std::span<const FitSample> nodes);
    void acceptUnlooked(const FitSample& a, const FitSample& b);
    void acceptUnsolved(double from, double to);

    double allowed(std::size_t i) const { return m_settings.tolerance * m_scale[i] + 8 * m_fit.largestError; }
    bool isSettled(std::span<const FitSample> nodes, double factor) const;
    bool ordersCount() const { return m_kinksLeft > 0; }
    bool isHopeless() const {
        return m_failures >= m_settings.failuresOfCell || m_failedEffort >= m_settings.mostFailedEffort;
    }
    bool mayWork() const { return m_fit.solves < m_solveLimit && !isSpent(); }
    bool isSpent() const { return m_effort >= m_settings.mostEffort; }

    const FitSettings& m_settings;
    const FitFunction& m_function;
    const std::stop_token& m_stop;
    const FitProgress& m_progress;
    PiecewiseFit m_fit;
    std::array<double, mostFitFunctions> m_scale;
    std::uint64_t m_solveLimit = 0;
    std::uint64_t m_kinksLeft = 0;
    std::uint64_t m_failures = 0;
    long m_effort = 0;
    long m_failedEffort = 0;
};

/// Not solved any more once a stop is requested.
FitSample Builder::solve(double x) {
    if (m_stop.stop_requested()) return {.x = x};
    FitSample sample = m_function(x);
    sample.x = x;
    ++m_fit.solves;
    m_effort += sample.effort;
    if (!sample.solved) {
        ++m_failures;
        m_failedEffort += sample.effort;
        return sample;
    }
    m_fit.largestError = std::max(m_fit.largestError, sample.error);
    for (std::size_t i = 0; i < m_settings.count; ++i)
        if (m_settings.scaleGrows[i]) m_scale[i] = std::max(m_scale[i], std::abs(sample.values[i]));
    return sample;
}

Chebyshev through(std::span<const FitSample> nodes, std::size_t output) {
    std::array<double, fineNodes> values{};
    for (std::size_t j = 0; j < nodes.size(); ++j) values[j] = nodes[j].values[output];
    return {nodes.front().x, nodes.back().x, std::span(values).first(nodes.size())};
}

/// Whether the last coefficients of all functions are within `factor` times what is allowed.
bool Builder::isSettled(std::span<const FitSample> nodes, double factor) const {
    for (std::size_t i = 0; i < m_settings.count; ++i)
        if (!(through(nodes, i).tail() <= factor * allowed(i))) return false;
    return true;
}

std::array<FitSample, coarseNodes> coarse(const Nodes& nodes) {
    std::array<FitSample, coarseNodes> chosen;
    for (std::size_t j = 0; j < coarseNodes; ++j) chosen[j] = nodes[2 * j];
    return chosen;
}

/// Whether polynomials through all nodes agree with the functions at two further points, and how well.
bool Builder::agrees(const Nodes& nodes, Errors& errors) {
    const double a = nodes.front().x, b = nodes.back().x;
    std::array<Chebyshev, mostFitFunctions> curves;
    for (std::size_t i = 0; i < m_settings.count; ++i) {
        curves[i] = through(nodes, i);
        errors[i] = 4 * curves[i].tail();
    }
    for (const double share : {0.2871, 0.9343}) {  // between nodes
        const FitSample check = solve(a + share * (b - a));
        if (!check.solved || (ordersCount() && check.order != nodes.front().order)) return false;
        for (std::size_t i = 0; i < m_settings.count; ++i) {
            const double difference = std::abs(curves[i](check.x) - check.values[i]);
            errors[i] = std::max(errors[i], 2 * difference + check.error);
        }
    }
    for (std::size_t i = 0; i < m_settings.count; ++i)
        if (!(errors[i] <= allowed(i))) return false;
    return true;
}

/// Takes the nodes between the first and the last, as far as is worth it.
Builder::Finding Builder::probe(Nodes& nodes) {
    const double a = nodes.front().x, b = nodes.back().x;
    bool solved = nodes.front().solved && nodes.back().solved;
    const auto differs = [&](std::size_t j) {
        nodes[j] = solve(Chebyshev::node(a, b, j, fineNodes));
        solved &= nodes[j].solved;
        return ordersCount() && solved && nodes[j].order != nodes.front().order;
    };
    if (differs(middleNode)) return {Finding::kink, middleNode};
    for (std::size_t j = 2; j + 1 < fineNodes; j += 2) {
        if (!solved && mayWork()) return {Finding::rough};
        if (j != middleNode && differs(j)) return {Finding::kink, j};
    }
    // Twice the nodes square the error: is it worth taking them?
    if (!solved || !isSettled(coarse(nodes), 1 / std::sqrt(m_settings.tolerance))) return {Finding::rough};
    for (std::size_t j = 1; j < fineNodes; j += 2) {
        if (differs(j)) return {Finding::kink, j};
        if (!solved) return {Finding::rough};
    }
    Finding finding{Finding::smooth};
    if (!isSettled(nodes, 0.25) || !agrees(nodes, finding.errors)) finding.kind = Finding::rough;
    return finding;
}

void Builder::refine(const FitSample& a, const FitSample& b) {
    if (m_stop.stop_requested() || !(b.x > a.x)) return;
    if (isHopeless()) return acceptUnsolved(a.x, b.x);
    if (isSpent()) return acceptUnlooked(a, b);
    if (b.x - a.x <= m_settings.leastWidth) return acceptAsIs(std::array{a, b});
    if (ordersCount() && a.solved && b.solved && a.order != b.order) return bracketKink(a, b);
    if (m_settings.ends == FitSettings::Ends::bracketed && !(a.solved && b.solved))
        return a.solved == b.solved ? lookForValues(a, b) : bracketEnd(a, b);

    Nodes nodes;
    nodes.front() = a;
    nodes.back() = b;
    const Finding finding = probe(nodes);
    if (finding.kind == Finding::smooth) return accept(nodes, finding.errors);
    if (finding.kind == Finding::rough && !mayWork()) return acceptAsIs(coarse(nodes));
    const FitSample& cut = nodes[finding.kind == Finding::kink ? finding.at : middleNode];
    refine(a, cut);
    refine(cut, b);
}

/// The order differs at the ends: finds one place where it changes.
void Builder::bracketKink(const FitSample& first, const FitSample& last) {
    --m_kinksLeft;
    FitSample a = first, b = last;
    while (b.x - a.x > m_settings.kinkWidth) {
        if (isSpent()) return acceptUnlooked(first, last);
        const FitSample middle = solve(a.x + (b.x - a.x) / 2);
        if (!middle.solved) {
            refine(first, a);
            refine(a, middle);
            refine(middle, b);
            return refine(b, last);
        }
        (middle.order == first.order ? a : b) = middle;
    }
    refine(first, a);
    acceptAsIs(std::array{a, b});
    m_fit.borders.push_back(a.x + (b.x - a.x) / 2);
    refine(b, last);
}

/// There are values at one end alone: finds one place where they end.
void Builder::bracketEnd(const FitSample& first, const FitSample& last) {
    FitSample a = first, b = last;
    while (b.x - a.x > m_settings.leastWidth && !isHopeless() && !isSpent()) {
        const FitSample middle = solve(a.x + (b.x - a.x) / 2);
        if (m_stop.stop_requested()) return;
        (middle.solved == first.solved ? a : b) = middle;
    }
    refine(first, a);
    acceptUnsolved(a.x, b.x);
    refine(b, last);
}

/// There are no values at the ends: there may be some between them.
void Builder::lookForValues(const FitSample& a, const FitSample& b) {
    for (std::size_t j = 1; j + 1 < coarseNodes; ++j) {
        const FitSample between = solve(Chebyshev::node(a.x, b.x, j, coarseNodes));
        if (!between.solved) continue;
        refine(a, between);
        return refine(between, b);
    }
    acceptUnsolved(a.x, b.x);
}

void Builder::accept(std::span<const FitSample> nodes, const Errors& errors) {
    FitPiece piece;
    piece.start = nodes.front().x;
    piece.end = nodes.back().x;
    piece.label = nodes[nodes.size() / 2].label;
    for (std::size_t i = 0; i < m_settings.count; ++i) {
        piece.outputs.push_back(through(nodes, i));
        piece.error.push_back(errors[i]);
        piece.resolved &= errors[i] <= allowed(i);
    }
    if (m_progress) m_progress(piece.end);
    m_fit.pieces.push_back(std::move(piece));
}

/// Too short to look closer, or too much work: off by no more than the values differ, in all likelihood.
void Builder::acceptAsIs(std::span<const FitSample> nodes) {
    if (!std::ranges::all_of(nodes, &FitSample::solved))
        return acceptUnsolved(nodes.front().x, nodes.back().x);
    Errors errors{};
    for (std::size_t i = 0; i < m_settings.count; ++i) {
        const auto value = [i](const FitSample& sample) { return sample.values[i]; };
        const auto [least, largest] = std::ranges::minmax(nodes, {}, value);
        errors[i] = value(largest) - value(least) + m_fit.largestError;
    }
    accept(nodes, errors);
}

/// All work is spent: equal values at both ends tell nothing of what is between them.
void Builder::acceptUnlooked(const FitSample& a, const FitSample& b) {
    acceptAsIs(std::array{a, b});
    m_fit.pieces.back().resolved = false;
}

void Builder::acceptUnsolved(double from, double to) {
    FitPiece piece;
    piece.start = from;
    piece.end = to;
    piece.solved = piece.resolved = false;
    m_fit.pieces.push_back(std::move(piece));
    m_fit.unsolved += to - from;
}

PiecewiseFit Builder::build(std::span<const double> cuts) {
    FitSample a = solve(cuts.front());
    for (const double cut : cuts.subspan(1)) {
        m_solveLimit += m_settings.solvesOfCell;
        m_kinksLeft += m_settings.kinksOfCell;
        m_failures = 0;
        if (isHopeless()) {
            acceptUnsolved(a.x, cuts.back());
            break;
        }
        FitSample b = solve(cut);
        refine(a, b);
        a = b;
    }
    return std::move(m_fit);
}

PiecewiseFit Builder::buildConstant(double start, double end) {
    const FitSample only = solve(start);
    FitSample atEnd = only;
    atEnd.x = end;
    acceptAsIs(std::array{only, atEnd});
    return std::move(m_fit);
}

}  // namespace

Chebyshev::Chebyshev(double a, double b, std::span<const double> values)
    : m_start(a), m_end(b), m_count(values.size()) {
    const std::size_t n = m_count - 1;
    const std::vector<double>& cosines = cosinesOf(n);
    for (std::size_t k = 0; k <= n; ++k) {
        double c = (values[0] + (k % 2 == 0 ? values[n] : -values[n])) / 2;
        for (std::size_t j = 1; j < n; ++j) c += values[j] * cosines[j * k % (2 * n)];
        // the nodes ascend, the cosines descend
        m_coefficients[k] = (k % 2 == 0 ? c : -c) * (k == 0 || k == n ? 1.0 : 2.0) / static_cast<double>(n);
    }
    const double scale = 2 / (b - a);
    double next = 0, afterNext = 0;  // d_{k+1}, d_{k+2}
    for (std::size_t k = n; k-- > 0;) {
        const double d = afterNext + 2 * static_cast<double>(k + 1) * m_coefficients[k + 1] * scale;
        m_slopes[k] = k == 0 ? d / 2 : d;
        afterNext = next;
        next = d;
    }
}

double Chebyshev::node(double a, double b, std::size_t j, std::size_t count) {
    if (j == 0) return a;
    if (j + 1 == count) return b;
    const double u = -cosinesOf(count - 1)[j];
    return a + (b - a) * ((1 + u) / 2);
}

double Chebyshev::operator()(double x) const {
    return sum(std::span(m_coefficients).first(m_count), position(x));
}

double Chebyshev::slope(double x) const {
    return sum(std::span(m_slopes).first(m_count - 1), position(x));
}

double Chebyshev::tail() const {
    double largest = 0;
    for (std::size_t k = m_count - std::min<std::size_t>(3, m_count - 1); k < m_count; ++k)
        largest = std::max(largest, std::abs(m_coefficients[k]));
    return largest;
}

std::vector<double> Chebyshev::stationaryPoints() const {
    std::vector<double> points;
    const std::size_t probes = 2 * mostNodes - 1;  // twice as many as p' can have zeros
    double a = m_start, slopeA = slope(a);
    for (std::size_t j = 1; j < probes; ++j) {
        const double b = m_start + (m_end - m_start) * (1 - cosine(j, probes - 1)) / 2;
        const double slopeB = slope(b);
        if (slopeB == 0) continue;
        if (slopeA != 0 && (slopeA > 0) != (slopeB > 0))
            points.push_back(brentRoot([this](double x) { return slope(x); }, a, slopeA, b, slopeB));
        a = b;
        slopeA = slopeB;
    }
    return points;
}

PiecewiseFit fitPiecewise(const FitSettings& settings, std::span<const double> cuts,
                          const FitFunction& function, const std::stop_token& stop,
                          const FitProgress& progress) {
    assert(settings.count >= 1 && settings.count <= mostFitFunctions && cuts.size() >= 2);
    return Builder(settings, function, stop, progress).build(cuts);
}

PiecewiseFit fitConstant(const FitSettings& settings, double start, double end, const FitFunction& function,
                         const std::stop_token& stop) {
    const FitProgress untold;
    return Builder(settings, function, stop, untold).buildConstant(start, end);
}

const FitPiece& pieceAt(std::span<const FitPiece> pieces, double x) {
    assert(!pieces.empty());
    const auto next = std::ranges::upper_bound(pieces, x, {}, &FitPiece::start);
    auto found = next == pieces.begin() ? next : std::prev(next);
    while (!found->solved && found != pieces.begin()) --found;  // the end of the piece before
    assert(found->solved);
    return *found;
}

std::vector<double> samplePlaces(std::span<const FitPiece> pieces, double farthest) {
    constexpr double nearest = 1e-9;
    std::vector<double> places;
    for (const FitPiece& piece : pieces) {
        if (!piece.solved) continue;
        if (places.empty()) places.push_back(piece.start);
        const int parts = std::max(1, static_cast<int>(std::ceil((piece.end - piece.start) / farthest)));
        for (int i = 0; i <= parts; ++i) {
            const double x = i == parts ? piece.end : piece.start + (piece.end - piece.start) * i / parts;
            if (x - places.back() > nearest) places.push_back(x);
        }
    }
    if (!places.empty() && pieces.back().end - places.back() <= nearest) places.back() = pieces.back().end;
    return places;
}

}  // namespace drillwave
