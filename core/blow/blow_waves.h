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

/// Reader of the forces and motion of a drill string over time, with the normal force and the waves at one of
/// its positions. It refers to the recorded waves of a blow, which must outlive it.
class StringHistory {
  public:
    /// Creates a reader for the position `place`. Requires recorded waves (impact.waves). Impact and problem
    /// must outlive the reader.
    StringHistory(const Impact& impact, const Problem& problem, const StringPlace& place);

    /// Returns the forces and motion of the drill string at the time t/t0, with the waves at the position of
    /// this reader. A time outside 0 … end() is moved to the nearer limit. At a jump, `side` selects the
    /// value before or after it.
    RodState at(double time, TimeSide side = TimeSide::after) const;
    /// Returns the time t/t0 up to which the waves are known.
    double end() const { return m_waves->end(); }
    /// Returns the results of at() for times from 0 to end(), for example to draw curves. Straight lines
    /// between them have an error of about 1e-4 F0. At a jump there are two entries for one time, before and
    /// after it.
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

/// Access to the waves of a uniform rod or a drill string, for pictures. Positions x/L are 0 at the struck
/// end (the shank of a string; the hammer is below 0) and 1 at the bit. Times are in t0, forces in F0,
/// velocities in F0/Z, lengths in d0. A rod is known at all times; for a string, values later than end() are
/// NaN.
class BlowWaves {
  public:
    /// Creates the access to the waves of a blow. The blow must have histories (Impact::hasHistories()) and
    /// outlive this object.
    explicit BlowWaves(const Blow& blow);

    /// Returns the position x/L at which the picture begins: 0, or the rear end of the hammer (negative).
    double rear() const { return m_string ? m_string->rear() : 0; }
    /// Returns the time t/t0 up to which waves and motions are known; infinite for a uniform rod.
    double end() const;
    /// Returns force or velocity at the centre of every cell of a grid over position and time, for a picture
    /// of the waves. Forces are in units of F0, velocities in F0/Z.
    WaveRaster raster(WaveQuantity quantity, const RasterGrid& grid) const;
    /// Returns force or velocity at the position x/L and the time t/t0, in units of F0 or F0/Z.
    double value(WaveQuantity quantity, double x, double t) const;
    /// Returns the forces and motion at the time t/t0, with the waves at the position x/L. For a drill
    /// string, a time later than end() counts as end(). Impulse and momentum are in units of I0, or of the
    /// hammer's momentum p0.
    RodState state(double x, double t) const;
    /// Returns forces and motion over the recorded time, for example to draw curves. A jump has two entries
    /// for one time. For a drill string, normal force and waves are those at `place`; for a uniform rod,
    /// those at the bit (sampledStates()).
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
    /// Returns the times t/t0 at which wave fronts start at the struck end, in increasing order. A wave front
    /// is the beginning, the end or a jump of the hammer force. Each time may be the `start` in frontRuns().
    std::vector<double> fronts() const;
    /// Returns the straight lines in the x–t diagram along which one wave front runs, between the times
    /// `begin` and `end`. The front starts at the struck end at the time `start`, one of fronts(). Times are
    /// in t0.
    std::vector<FrontRun> frontRuns(double start, double begin, double end) const;

    /// Returns the intervals of contact of bit and rock, in order of time, in units of t0. A contact that
    /// lasts longer than the computation ends at end().
    std::vector<ContactInterval> contacts() const;
    /// Returns the intervals of contact of hammer and string, in order of time, in units of t0; empty for a
    /// uniform rod. A contact that lasts longer than the computation ends at end().
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
