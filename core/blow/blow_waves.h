// SPDX-License-Identifier: GPL-3.0-or-later
// Waves and motions of a blow over place and time, on a rod or a drill string.
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

// A blow on a drill string over time: at the bit, at the face of the hammer, and at a place in between.

/// A place in hammer or string; a uniform rod is one section.
struct StringPlace {
    std::size_t section = 0;  ///< of allSections()
    double share = 0;         ///< ξ, 0 at its rear end … 1
    bool operator==(const StringPlace&) const = default;
};

/// Returns the place of the hammer's rear, in lengths of the string from the shank: below 0 with a hammer.
double hammerRear(const DrillString& drillString);

/// The place at a share of the length of the string, 0 at the shank … 1 at the bit, below 0 in the hammer.
StringPlace stringPlace(const DrillString& drillString, double share);

/// Returns the bar of gauges on the uniform rod, or at a share of the length of the string as in
/// stringPlace().
SignalBar barAt(const Scenario& scenario, double share);

/// The other way round.
double shareOfString(const DrillString& drillString, const StringPlace& place);

/// The middle of the longest section of the string, of the first where several are as long; of a rod.
StringPlace middleOfLongest(const DrillString& drillString);

/// Reads a blow whose waves were kept; the blow must outlive it.
class StringHistory {
  public:
    StringHistory(const Impact& impact, const Problem& problem, const StringPlace& place);

    RodState at(double time, TimeSide side = TimeSide::after) const;
    double end() const { return m_waves->end(); }
    /// Returns states from 0 to end(), two at a time with a jump; chords follow the curves to about 1e-4 F0.
    std::vector<RodState> sampled() const;

  private:
    std::vector<double> pieceTimes() const;

    const Impact* m_impact;
    const Problem* m_problem;
    const StringWaves* m_waves;
    StringPlace m_place;
};

/// Returns the places where the sections of hammer and string begin and the last one ends, in lengths of the
/// string from the shank: the hammer is below 0, the bit at 1.
std::vector<double> sectionJoints(const DrillString& drillString);

/// Access to the waves of rods and strings for pictures. Places x/L are 0 at the struck end (the shank of a
/// string; the hammer is below 0) and 1 at the bit; times in t0, forces in F0, velocities in F0/Z, lengths
/// in d0. A rod is known at all times; a string until end(), later values are NaN.
class BlowWaves {
  public:
    /// Requires a blow with histories (Impact::hasHistories()), which must outlive this object.
    explicit BlowWaves(const Blow& blow);

    /// Returns the place where the picture begins: 0, or the rear end of the hammer.
    double rear() const { return m_string ? m_string->rear() : 0; }
    /// Returns the time until which everything is known; infinite for a rod.
    double end() const;
    WaveRaster raster(WaveQuantity quantity, const RasterGrid& grid) const;
    double value(WaveQuantity quantity, double x, double t) const;
    /// Returns the state of a string at end() for later t; impulse and momentum in units of the results.
    RodState state(double x, double t) const;
    /// Returns the states over the recorded time, twice where something jumps: at a place of a string,
    /// or at the bit of a rod as sampledStates().
    std::vector<RodState> sampled(const StringPlace& place) const;

    /// Returns the span from the first touch of hammer and string, or the start of the pulse, to a round trip
    /// after the last separation of bit and rock; at most a dozen round trips.
    TimeSpan interesting() const;
    /// Return the arrival time of the first wave at the bit, and the time for a round trip from there.
    double arrival() const;
    double roundTrip() const;
    /// Returns the times at which fronts start at the struck end; frontRuns() follows one between two times.
    std::vector<double> fronts() const;
    std::vector<FrontRun> frontRuns(double start, double begin, double end) const;

    /// Returns the contacts of bit and rock, in order; one that was not followed to its end lasts to end().
    std::vector<ContactInterval> contacts() const;
    /// Returns the contacts of hammer and string, in the same way; none for a rod.
    std::vector<ContactInterval> faceContacts() const;
    /// Returns the state of the bit; `contacts` as returned by contacts().
    BitState bit(const std::vector<ContactInterval>& contacts, double t) const;
    double impactForce(double t) const;

  private:
    const Blow* m_blow;
    std::optional<StringField> m_string;
};

}  // namespace drillwave
