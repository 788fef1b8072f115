// SPDX-License-Identifier: GPL-3.0-or-later
// Waves and motions of a blow as functions of position and time, for a rod or a drill string.
#pragma once

#include <optional>
#include <vector>

#include "core/blow/blow.h"
#include "core/model/drill_string.h"
#include "core/signal/signal_reading.h"
#include "core/wave/field/bit_history.h"
#include "core/wave/field/interesting_time.h"
#include "core/wave/field/rod_state.h"
#include "core/wave/field/string_field.h"
#include "core/wave/field/wave_field.h"
#include "core/wave/field/wave_fronts.h"
#include "core/wave/impact.h"
#include "core/wave/network/string_waves.h"
#include "core/wave/problem.h"

namespace drillwave {

// Blow on a drill string over time: at the bit, at the hammer face, and at a position between them

/// Position in the sections of hammer and string. A uniform rod counts as one section.
struct StringPlace {
    /// Index of the section in allSections(), which lists the sections of the hammer before those of the
    /// string.
    std::size_t section = 0;
    /// Position ξ in the section, 0 at its rear end … 1 at its front end.
    double share = 0;
    bool operator==(const StringPlace&) const = default;
};

/// Returns the position of the hammer's rear end, in lengths of the string from the shank; negative with a
/// hammer, 0 without.
double hammerRear(const DrillString& drillString);

/// Returns the position at a share of the string's length: 0 at the shank, 1 at the bit, negative in the
/// hammer. Shares beyond the ends give the nearer end.
StringPlace stringPlace(const DrillString& drillString, double share);

/// Returns cross-section, modulus and impedance of the bar with strain gauges: that of the uniform rod, or
/// that of the string at `share` of its length (0 at the shank, 1 at the bit, negative in the hammer).
SignalBar barAt(const Scenario& scenario, double share);

/// Returns the share of the string's length at a position: 0 at the shank, 1 at the bit, negative in the
/// hammer.
double shareOfString(const DrillString& drillString, const StringPlace& place);

/// Returns the middle of the longest section of the string, the first of several of the same length. For a
/// uniform rod it is the middle of the rod.
StringPlace middleOfLongest(const DrillString& drillString);

/// Reader of the state at one position of a blow whose waves were recorded. The blow must outlive it.
class StringHistory {
  public:
    /// Creates a reader of the state at one position over time. Requires recorded waves (impact.waves).
    StringHistory(const Impact& impact, const Problem& problem, const StringPlace& place);

    /// Returns the state at the time t/t0. A time outside 0 … end() gives the state at the nearer end. At a
    /// jump, `side` selects the value before or after it.
    RodState at(double time, TimeSide side = TimeSide::after) const;
    /// Returns the time t/t0 up to which the waves are known.
    double end() const { return m_waves->end(); }
    /// Returns the states at times from 0 to end(), to be joined by straight lines, with an error of about
    /// 1e-4 F0. At a jump there are two states at the same time.
    std::vector<RodState> sampled() const;

  private:
    std::vector<double> pieceTimes() const;

    const Impact* m_impact;
    const Problem* m_problem;
    const StringWaves* m_waves;
    StringPlace m_place;
};

/// Returns the positions at which the sections of hammer and string begin, and the end of the last one. They
/// are in lengths of the string from the shank: the hammer is below 0, the bit at 1.
std::vector<double> sectionJoints(const DrillString& drillString);

/// Access to the waves of rods and strings for pictures. Positions x/L are 0 at the struck end (the shank of
/// a string; the hammer is below 0) and 1 at the bit. Times are in t0, forces in F0, velocities in F0/Z,
/// lengths in d0. A rod is known at all times; for a string, values later than end() are NaN.
class BlowWaves {
  public:
    /// Creates the access to a blow with histories (Impact::hasHistories()), which must outlive it.
    explicit BlowWaves(const Blow& blow);

    /// Returns the position x/L at which the picture begins: 0, or the rear end of the hammer (negative).
    double rear() const { return m_string ? m_string->rear() : 0; }
    /// Returns the time t/t0 up to which waves and motions are known; infinite for a uniform rod.
    double end() const;
    /// Returns force or velocity at the centre of every cell of the grid, in units of F0 or F0/Z.
    WaveRaster raster(WaveQuantity quantity, const RasterGrid& grid) const;
    /// Returns force or velocity at the position x/L and the time t/t0, in units of F0 or F0/Z.
    double value(WaveQuantity quantity, double x, double t) const;
    /// Returns the state at the position x/L and the time t/t0; for a string, t is limited to end(). Impulse
    /// and momentum have the units of the results: I0, or the hammer's momentum p0.
    RodState state(double x, double t) const;
    /// Returns the states over the recorded time, with two states at the same time at a jump. For a string
    /// they are the states at `place`, for a uniform rod those at the bit (sampledStates()).
    std::vector<RodState> sampled(const StringPlace& place) const;

    /// Returns the interval of time that a picture shows at first, in units of t0. It begins with the blow,
    /// or shortly before the first contact of bit and rock if the flight before it is long. It ends one round
    /// trip after the last separation, or after the arrival of the blow at the bit if that is later. It is at
    /// most a dozen round trips long.
    TimeSpan interesting() const;
    /// Returns the time t/t0 at which the first wave reaches the bit.
    double arrival() const;
    /// Returns the time that a wave needs from the bit to the struck end and back, in units of t0.
    double roundTrip() const;
    /// Returns the times t/t0 at which wave fronts start at the struck end, in increasing order.
    std::vector<double> fronts() const;
    /// Returns the paths, between the times `begin` and `end`, of the wave front that starts at the struck
    /// end at the time `start`. Times are in t0.
    std::vector<FrontRun> frontRuns(double start, double begin, double end) const;

    /// Returns the intervals of contact of bit and rock, in order of time, in units of t0. If the computation
    /// ended during a contact, that contact lasts to end().
    std::vector<ContactInterval> contacts() const;
    /// Returns the intervals of contact of hammer and string, in order of time, in units of t0; empty for a
    /// rod. If the computation ended during a contact, that contact lasts to end().
    std::vector<ContactInterval> faceContacts() const;
    /// Returns the contact state of bit and rock at the time t/t0; `contacts` is the result of contacts().
    BitState bit(const std::vector<ContactInterval>& contacts, double t) const;
    /// Returns the impact force F/F0 at the time t/t0; ≥ 0.
    double impactForce(double t) const;

  private:
    const Blow* m_blow;
    std::optional<StringField> m_string;
};

}  // namespace drillwave
