// SPDX-License-Identifier: GPL-3.0-or-later
// The waves of a blow at any section and at any time (theory §3).
#pragma once

#include <cstddef>
#include <vector>

#include "core/wave/impact.h"

namespace drillwave {

// Travel times of waves between a section of the uniform rod and the bit. No other file computes them.

/// Direction in which a wave runs: towards the bit, or from the bit towards the hammer.
enum class Heading { toBit, fromBit };

/// Travel times of waves in the rod for one blow, for the files of this folder only. s is the time at the bit
/// since the arrival of the first wave there, t the time since the start of the blow, both in units of t0. ξ
/// = x/L is 0 at the rear end and 1 at the bit.
class RodDelays {
  public:
    explicit RodDelays(const Impact& impact)
        : m_arrival(impact.frontArrival), m_roundTrip(impact.roundTrip) {}

    /// Returns the time t/t0 at which the first wave reaches the bit, where s = 0.
    double arrival() const { return m_arrival; }
    /// Returns the round trip 2τ of a wave in the rod, in units of t0.
    double roundTrip() const { return m_roundTrip; }
    /// Returns the one-way transit time τ of a wave in the rod, in units of t0.
    double transitTime() const { return m_roundTrip / 2; }

    /// Returns the time s/t0, counted at the bit, for a wave that is at the section ξ at the time t. A wave
    /// towards the bit will reach it at s = t + (1 − ξ)τ − arrival. A wave from the bit has left it at s = t
    /// − (1 − ξ)τ − arrival.
    double atBit(Heading heading, double xi, double t) const {
        const double way = (1 - xi) * m_roundTrip / 2;
        return heading == Heading::toBit ? t - m_arrival + way : t - m_arrival - way;
    }
    /// Returns the difference t − s between the time at the section ξ and the time at the bit, for a wave in
    /// the given direction, in units of t0.
    double shift(Heading heading, double xi) const {
        return m_arrival + (heading == Heading::toBit ? -1 : 1) * (1 - xi) * transitTime();
    }

  private:
    double m_arrival, m_roundTrip;
};

/// Waves, forces and motion of a uniform rod at any section and time. t is the time in t0 since the start of
/// the hammer force, or since first contact in the reference case (a rod that arrives as a rigid body). ξ =
/// x/L is 0 at the rear end and 1 at the bit. Forces are in F0, impulses in I0.
///
/// Requires an impact solved with Detail::histories, which must outlive the field; arrival() and roundTrip()
/// only require Detail::summary.
class WaveField {
  public:
    explicit WaveField(const Impact& impact) : m_impact(&impact), m_delays(impact) {}

    /// Returns the time t/t0 at which the first wave reaches the bit; 0 in the reference case (a rod that
    /// arrives as a rigid body), which starts with contact.
    double arrival() const { return m_delays.arrival(); }
    /// Returns the round-trip time of a wave in the rod, in units of t0. Residual waves repeat with this
    /// period.
    double roundTrip() const { return m_delays.roundTrip(); }

    /// Returns the impact force F(t)/F0 between bit and rock; ≥ 0.
    double impactForce(double t) const;
    /// Returns the impulse of the impact force up to the time t, ∫F, in units of I0.
    double impactImpulse(double t) const;

    /// Returns the wave Np/F0 at the section ξ, which runs to +x, towards the bit; tension positive.
    double positiveWave(double xi, double t) const;
    /// Returns the wave Nn/F0 at the section ξ, which runs to −x, towards the hammer; tension positive.
    double negativeWave(double xi, double t) const;
    /// Returns the normal force N = Np + Nn at the section ξ, in units of F0, tension positive.
    double force(double xi, double t) const;
    /// Returns the particle velocity v = (Nn − Np)/Z at the section ξ, in units of F0/Z, positive towards the
    /// rock.
    double velocity(double xi, double t) const;

  private:
    const Impact* m_impact;
    RodDelays m_delays;
};

// Force and particle velocity over a grid of sections and times, for the x–t picture of a blow.

/// Quantity that an x–t picture of the rod shows.
enum class WaveQuantity {
    /// Normal force N = Np + Nn, in units of F0, tension positive.
    force,
    /// Particle velocity v = (Nn − Np)/Z, in units of F0/Z, positive towards the rock.
    velocity,
};

/// Grid of rectangles (cells) of equal size over a part of the plane of position ξ = x/L and time t/t0 since
/// the start of the blow.
struct RasterGrid {
    /// Range of sections ξ = x/L that the columns of the grid cover: 0 is the rear end, 1 the bit.
    double xiBegin = 0, xiEnd = 1;
    /// Number of columns of the grid; each is an equal part of the range of sections; ≥ 0.
    int columns = 0;
    /// Range of times t/t0 since the start of the blow that the rows of the grid cover.
    double timeBegin = 0, timeEnd = 1;
    /// Number of rows of the grid; each is an equal part of the range of times; ≥ 0.
    int rows = 0;
    bool operator==(const RasterGrid&) const = default;

    /// Returns the section ξ at the centre of a column of the grid. It may be outside the rod.
    double xi(int column) const { return xiBegin + (xiEnd - xiBegin) * (column + 0.5) / columns; }
    /// Returns the time t/t0 at the centre of a row of the grid.
    double time(int row) const { return timeBegin + (timeEnd - timeBegin) * (row + 0.5) / rows; }
    /// Returns the index of a cell of the grid in WaveRaster::values, which go row by row.
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
};

/// Values of a wave quantity (force or velocity) at the centres of the rectangles of an x–t grid, for a
/// picture.
struct WaveRaster {
    WaveQuantity quantity = WaveQuantity::force;
    RasterGrid grid;
    /// Values of the quantity at the cells of the grid, row by row from timeBegin; NaN outside the rod.
    std::vector<float> values;
    /// Number of pieces of the histories that were examined, a measure of the work: at most a few for each
    /// cell of the grid.
    long steps = 0;
};

/// Returns the quantity at the centre of every cell of the grid, in a uniform rod. The values are exact, so
/// jumps stay jumps at any size of the cells. The work grows with the number of cells, but hardly with the
/// number of pieces or round trips. Requires an impact solved with Detail::histories.
WaveRaster waveRaster(const Impact& impact, WaveQuantity quantity, const RasterGrid& grid);

/// Returns the quantity at the section ξ = x/L and the time t/t0 since the start of the blow. Force is in F0,
/// velocity in F0/Z.
double waveValue(const Impact& impact, WaveQuantity quantity, double xi, double t);

}  // namespace drillwave
