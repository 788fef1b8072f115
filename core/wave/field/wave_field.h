// SPDX-License-Identifier: GPL-3.0-or-later
// The waves of a blow at any section and at any time (theory §3).
#pragma once

#include <cstddef>
#include <vector>

#include "core/wave/impact.h"

namespace drillwave {

// How long waves take between a section of the uniform rod and the bit: the one place where that is known.

/// Which way a wave runs.
enum class Heading { toBit, fromBit };

/// The delays of one blow, for the files of this folder only. s is the time at the bit since the arrival of
/// the first wave there, t the global time, ξ = x/L: rear end 0, bit 1; times in t0.
class RodDelays {
  public:
    explicit RodDelays(const Impact& impact)
        : m_arrival(impact.frontArrival), m_roundTrip(impact.roundTrip) {}

    double arrival() const { return m_arrival; }            ///< global time of s = 0
    double roundTrip() const { return m_roundTrip; }        ///< 2τ
    double transitTime() const { return m_roundTrip / 2; }  ///< τ

    /// Returns the time when the wave at ξ at time t reaches the bit, s = t + (1 − ξ)τ − arrival, or left it,
    /// t − (1 − ξ)τ − arrival.
    double atBit(Heading heading, double xi, double t) const {
        const double way = (1 - xi) * m_roundTrip / 2;
        return heading == Heading::toBit ? t - m_arrival + way : t - m_arrival - way;
    }
    /// Returns the difference t − s for the wave that is at ξ at the time t.
    double shift(Heading heading, double xi) const {
        return m_arrival + (heading == Heading::toBit ? -1 : 1) * (1 - xi) * transitTime();
    }

  private:
    double m_arrival, m_roundTrip;
};

/// Waves and motion of the rod at any time: t is the global time in t0 from the beginning of the hammer force
/// (from first contact in the reference case); ξ = x/L, rear end 0 … bit 1. Forces in F0, impulses in I0.
///
/// Needs an impact solved with Detail::histories, which must outlive the field; arrival() and roundTrip() are
/// known with Detail::summary.
class WaveField {
  public:
    explicit WaveField(const Impact& impact) : m_impact(&impact), m_delays(impact) {}

    /// Returns when the first wave reaches the bit; 0 in the reference case, which begins there.
    double arrival() const { return m_delays.arrival(); }
    /// Returns the round-trip time of a wave in the rod. Residual waves repeat themselves after it.
    double roundTrip() const { return m_delays.roundTrip(); }

    double impactForce(double t) const;    ///< F(t) ≥ 0 of bit and rock
    double impactImpulse(double t) const;  ///< ∫F up to t

    double positiveWave(double xi, double t) const;  ///< Np, which runs to +x, the bit; tension positive
    double negativeWave(double xi, double t) const;  ///< Nn, which runs to −x; tension positive
    double force(double xi, double t) const;         ///< N = Np + Nn, tension positive
    double velocity(double xi, double t) const;      ///< v = (Nn − Np)/Z [F0/Z], positive towards the rock

  private:
    const Impact* m_impact;
    RodDelays m_delays;
};

// Force and particle velocity over a grid of sections and times: the x–t picture of a blow.

/// Quantity shown in the rod.
enum class WaveQuantity {
    force,     ///< N = Np + Nn [F0], tension positive
    velocity,  ///< v = (−Np + Nn)/Z [F0/Z], positive towards the rock
};

/// Cells of equal size over a rectangle of ξ = x/L and global time t/t0.
struct RasterGrid {
    double xiBegin = 0, xiEnd = 1;
    int columns = 0;
    double timeBegin = 0, timeEnd = 1;
    int rows = 0;
    bool operator==(const RasterGrid&) const = default;

    /// Centre of a cell; may lie outside the rod.
    double xi(int column) const { return xiBegin + (xiEnd - xiBegin) * (column + 0.5) / columns; }
    double time(int row) const { return timeBegin + (timeEnd - timeBegin) * (row + 0.5) / rows; }
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
};

/// The quantity at the centres of the cells.
struct WaveRaster {
    WaveQuantity quantity = WaveQuantity::force;
    RasterGrid grid;
    std::vector<float> values;  ///< row by row from timeBegin; NaN outside the rod
    long steps = 0;             ///< pieces of the histories looked at: a few for each cell at most
};

/// Exact at every centre: jumps stay jumps at any size of the cells. Needs an impact solved with
/// Detail::histories. The work grows with the number of cells, hardly with that of pieces or of round trips.
WaveRaster waveRaster(const Impact& impact, WaveQuantity quantity, const RasterGrid& grid);

/// The quantity at one place, dimensionless as above.
double waveValue(const Impact& impact, WaveQuantity quantity, double xi, double t);

}  // namespace drillwave
