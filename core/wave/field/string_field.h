// SPDX-License-Identifier: GPL-3.0-or-later
// Waves in hammer and string as functions of position and time.
#pragma once

#include <cstddef>
#include <vector>

#include "core/wave/field/wave_field.h"
#include "core/wave/field/wave_fronts.h"
#include "core/wave/network/string_waves.h"

namespace drillwave {

/// Reader of the waves in hammer and string at any position and time. It keeps a reference to the
/// StringWaves, which must outlive it. Positions x are in lengths of the string from the shank: the hammer is
/// at x < 0, the bit at x = 1. Times are in t0, forces in F0 (tension positive), velocities in F0/Z (positive
/// towards the rock). Values are NaN outside hammer and string, and after the end of the computation.
class StringField {
  public:
    /// Creates a reader of `waves`. `joints` are the positions x of the ends of all sections, from the rear
    /// end of the hammer to the bit: one more than there are sections.
    StringField(const StringWaves& waves, const std::vector<double>& joints);

    /// Returns the position x of the rear end of the hammer, in lengths of the string; ≤ 0.
    double rear() const { return m_joints.front(); }
    /// Returns the time t/t0 to which the waves were recorded.
    double end() const { return m_waves->end(); }
    /// Returns the index of the uniform piece of hammer or string at the position x, counted from 0 at the
    /// hammer's rear end. At the border of two pieces, it is the piece nearer the hammer's rear end.
    std::size_t sectionAt(double x) const;
    /// Returns normal force or velocity at the position x and the time t/t0; NaN if x is outside hammer and
    /// string, or if t is later than end().
    double value(WaveQuantity quantity, double x, double t) const;
    /// Returns the quantity at the centre of every cell of the grid, computed for this point without
    /// interpolation. The work grows with the number of cells.
    WaveRaster raster(WaveQuantity quantity, const RasterGrid& grid) const;

    /// Returns the travel time of a wave from the shank to the bit, in units of t0.
    double arrival() const { return m_arrival; }
    /// Returns the travel time of a wave from the hammer face to the hammer's rear end and back, in units of
    /// t0.
    double hammerRoundTrip() const { return m_hammerRoundTrip; }
    /// Returns the straight paths in the x–t diagram of a wave front that leaves the shank at the time
    /// `start` and runs to and fro in the string. There is one path for each passage of a uniform piece;
    /// paths outside the times `begin` … `end` are left out. If start = 0, when the hammer first touches, the
    /// path of the front in the hammer is included. Partial reflections at joints are not followed. Times are
    /// in units of t0.
    std::vector<FrontRun> frontRuns(double start, double begin, double end) const;

  private:
    struct Column;
    Column columnAt(double x) const;
    bool isInside(double x) const { return x >= m_joints.front() && x <= m_joints.back(); }
    void addRuns(std::vector<FrontRun>& runs, std::size_t first, std::size_t last, double start,
                 long number) const;

    const StringWaves* m_waves;
    std::vector<double> m_joints;
    std::size_t m_hammerSections;
    double m_arrival = 0, m_hammerRoundTrip = 0;
};

}  // namespace drillwave
