// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/relaxation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drillwave {

namespace {

using Powers = WaveCell::Powers;

/// q − q'/rate + q''/rate² − q'''/rate³: the solution that has forgotten how it began.
Powers slowSolution(const Powers& q, double rate) {
    Powers y = q;
    for (int k = WaveCell::count - 2; k >= 0; --k) y[k] = q[k] - (k + 1) * y[k + 1] / rate;
    return y;
}

double sizeOf(const Powers& p) {
    double sum = 0;
    for (const double coefficient : p) sum += std::abs(coefficient);
    return sum;
}

/// From here on the layer is thinner than the rounding of times in the cell.
constexpr double instantRate = 1e13;

/// From here on nothing of the start of a cell is left at its end.
constexpr double forgottenRate = 40;

/// The solution over the cell, and y at its end.
struct Followed {
    WaveCell cell;
    double end = 0;
};

Followed followPieces(const Powers& input, double rate, double start) {
    CellProjection projection;
    double y = start;
    for (double from = 0; from < 1;) {
        const RelaxationPiece piece = relaxationPiece(input, rate, y, from);
        const bool last = from + piece.width >= 1;
        const double to = last ? 1 : from + piece.width;
        projection.add(from, to, [&](double u) { return piece.value((u - piece.from) / piece.width); });
        y = piece.value(1);
        from = to;
    }
    return {projection.cell(), y};
}

}  // namespace

Powers seenFrom(const Powers& p, double from, double width) {
    Powers q = p;
    for (int i = 0; i + 1 < WaveCell::count; ++i)
        for (int k = WaveCell::count - 2; k >= i; --k) q[k] += from * q[k + 1];
    double power = 1;
    for (double& coefficient : q) coefficient *= power, power *= width;
    return q;
}

RelaxationPiece relaxationPiece(const Powers& input, double rate, double start, double from, double to) {
    constexpr double farthest = 1;  // width · rate: the series ends at 1/20! there
    RelaxationPiece piece;
    piece.from = from;
    const double left = to - from;
    if (rate * left > 4 * farthest) {
        const Powers slow = seenFrom(slowSolution(input, rate), from, left);
        const double noise = 4 * std::numeric_limits<double>::epsilon();
        const double size = std::max({sizeOf(slow), sizeOf(input), std::abs(start)});
        if (rate > instantRate || std::abs(start - slow[0]) <= noise * size) {
            piece.width = left;
            piece.count = WaveCell::count;
            std::copy_n(slow.begin(), WaveCell::count, piece.c.begin());
            return piece;
        }
    }
    piece.width = std::min(left, farthest / rate);
    const Powers q = seenFrom(input, from, piece.width);
    const double step = rate * piece.width;
    piece.count = RelaxationPiece::capacity;
    piece.c[0] = start;
    for (int k = 0; k + 1 < piece.count; ++k)
        piece.c[k + 1] = step * ((k < WaveCell::count ? q[k] : 0) - piece.c[k]) / (k + 1);
    return piece;
}

Relaxation::Relaxation(double rate) {
    if (rate > forgottenRate) {
        makeFast(rate);
        return;
    }
    for (int l = 0; l < WaveCell::count; ++l) {
        WaveCell unit;
        unit.c[l] = 1;
        const Followed followed = followPieces(unit.powers(), rate, 0);
        m_ofInput[l] = followed.cell.c;
        m_endOfInput[l] = followed.end;
    }
    const Followed followed = followPieces({}, rate, 1);
    m_ofStart = followed.cell.c;
    m_kept = followed.end;
}

/// The slow solution, and a layer e^(−rate u) that has gone when the cell ends: ∫u^k e^(−rate u) =
/// k!/rate^(k+1).
void Relaxation::makeFast(double rate) {
    const double m0 = 1 / rate, m1 = m0 / rate, m2 = 2 * m1 / rate, m3 = 3 * m2 / rate;
    m_ofStart = {m0, 3 * (2 * m1 - m0), 5 * (6 * m2 - 6 * m1 + m0), 7 * (20 * m3 - 30 * m2 + 12 * m1 - m0)};
    m_kept = 0;
    for (int l = 0; l < WaveCell::count; ++l) {
        WaveCell unit;
        unit.c[l] = 1;
        const WaveCell slow = WaveCell::fromPowers(slowSolution(unit.powers(), rate));
        m_endOfInput[l] = slow.end();
        for (int k = 0; k < WaveCell::count; ++k) m_ofInput[l][k] = slow.c[k] - slow.start() * m_ofStart[k];
    }
}

double OscillationRates::fastest() const {
    return std::max(impedance / mass, std::sqrt(slope / mass));
}

OscillationPiece oscillationPiece(const OscillationRates& rates, const WaveCell::Powers& g, double width,
                                  double velocity, double force) {
    OscillationPiece piece;
    piece.width = width;
    piece.velocity[0] = velocity;
    piece.force[0] = force;
    const double toVelocity = width / rates.mass, toForce = width * rates.slope;
    for (int k = 0; k + 1 < OscillationPiece::capacity; ++k) {
        const double wave = k < WaveCell::count ? 2 * g[k] : 0;
        piece.velocity[k + 1] =
            toVelocity * (wave - rates.impedance * piece.velocity[k] - piece.force[k]) / (k + 1);
        piece.force[k + 1] = toForce * piece.velocity[k] / (k + 1);
    }
    return piece;
}

Oscillation::Column Oscillation::columnOf(const OscillationRates& rates, double width, const WaveCell& g,
                                          double velocity, double force) {
    const WaveCell::Powers powers = g.powers();
    const int pieces = static_cast<int>(std::max(1.0, std::ceil(width * rates.fastest())));
    CellProjection velocities, forces;
    Column column{{}, {}, velocity, force};
    for (int i = 0; i < pieces; ++i) {
        const double from = double(i) / pieces, to = double(i + 1) / pieces;
        const OscillationPiece piece = oscillationPiece(rates, seenFrom(powers, from, to - from),
                                                        (to - from) * width, column.velocity, column.force);
        const auto local = [&](double u) { return (u - from) / (to - from); };
        velocities.add(from, to, [&](double u) { return piece.velocityAt(local(u)); });
        forces.add(from, to, [&](double u) { return piece.forceAt(local(u)); });
        column.velocity = piece.velocityAt(1);
        column.force = piece.forceAt(1);
    }
    column.velocities = velocities.cell();
    column.forces = forces.cell();
    return column;
}

Oscillation::Oscillation(const OscillationRates& rates, double width) {
    for (int l = 0; l < WaveCell::count; ++l) {
        WaveCell unit;
        unit.c[l] = 1;
        m_columns[l] = columnOf(rates, width, unit, 0, 0);
    }
    m_columns[WaveCell::count] = columnOf(rates, width, {}, 1, 0);
    m_columns[WaveCell::count + 1] = columnOf(rates, width, {}, 0, 1);
}

void Oscillation::follow(const WaveCell& g, double& velocity, double& force, WaveCell& velocities,
                         WaveCell& forces) const {
    velocities = {};
    forces = {};
    double nextVelocity = 0, nextForce = 0;
    for (int i = 0; i < inputs; ++i) {
        const double factor = i < WaveCell::count ? g.c[i] : i == WaveCell::count ? velocity : force;
        const Column& column = m_columns[i];
        velocities += factor * column.velocities;
        forces += factor * column.forces;
        nextVelocity += factor * column.velocity;
        nextForce += factor * column.force;
    }
    velocity = nextVelocity;
    force = nextForce;
}

}  // namespace drillwave
