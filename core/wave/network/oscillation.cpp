// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/oscillation.h"

#include <algorithm>
#include <cmath>

#include "core/wave/network/relaxation.h"

namespace drillwave {

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
