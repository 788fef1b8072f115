// SPDX-License-Identifier: GPL-3.0-or-later
// Contact of bit and rock: arriving wave, force on the rock, and reflected wave (strings §5).
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/contact/contact_law.h"
#include "core/numeric/first_zero.h"
#include "core/wave/impact.h"
#include "core/wave/network/relaxation.h"
#include "core/wave/network/wave_cell.h"

namespace drillwave {

/// Sums and extremes of the impact force up to a time, in the dimensionless units of Problem (problem.h):
/// times in t0, forces in F0, impulses in I0.
struct BitRecord {
    /// Impulse of the impact force, ∫F dt, in units of I0.
    double impulse = 0;
    /// First moment of the impact force over time, ∫F t dt, in units of I0 t0.
    double impulseMoment = 0;
    /// Largest impact force F between bit and rock, in units of F0.
    double peakForce = 0;
    /// Time t/t0 of the largest impact force.
    double peakTime = 0;
    /// Time t/t0 of the first contact; negative if there was none.
    double firstContact = -1;
    /// Time t/t0 at which the last contact began; negative if there was none.
    double lastContact = -1;
    /// Time t/t0 of the last separation; negative if there was none.
    double lastSeparation = -1;
    /// Sum of the durations of all contacts, in units of t0.
    double contactDuration = 0;
    /// Number of contacts that have begun.
    int contacts = 0;
};

/// State of bit and rock at one time, with the record of the contact so far. Lengths are in I0/Zr, forces in
/// F0, velocities in F0/Zr.
struct BitNodeState {
    /// Creates a bit on a default rock, without a gap.
    BitNodeState() : BitNodeState(ContactLaw<double>(BitRockLaw{}), 0) {}
    /// Creates a bit at the distance `gap` ≥ 0 from a rock with the law `untouched`.
    BitNodeState(const ContactLaw<double>& untouched, double gap) : law(untouched), distance(gap) {}

    /// Law of bit and rock, which includes the largest force that the rock remembers.
    ContactLaw<double> law;
    /// Line of the law on which bit and rock are now; `apart` if they do not touch.
    ContactLine line = ContactLine::apart;
    /// Impact force F of bit and rock, in units of F0; ≥ 0.
    double force = 0;
    /// Velocity of the bit mass in units of F0/Zr, positive towards the rock; not used without a bit mass.
    double velocity = 0;
    /// Distance from the bit to the rock or to the bottom of its crater, in units of I0/Zr; valid only while
    /// they are apart.
    double distance;
    /// Sums and extremes of the impact force so far.
    BitRecord record;

    /// Returns whether bit and rock are apart.
    bool isApart() const { return line == ContactLine::apart; }
    /// Returns the penetration U of the bit, from the original surface of the rock, in units of I0/Zr.
    double penetration() const {
        return isApart() ? law.residualPenetration() - distance : law.penetration(force);
    }
};

/// Front end of the string, with or without the mass of a bit:
///
///     M U'' + Z U' + F(U) = 2g,    b = g − Z U'        (M = 0: U' = (2g − F)/Z, b = F − g)
///
/// g is the arriving wave, b the reflected wave, F the piecewise linear law of bit and rock with memory. A
/// cell (time step) without a contact event is one product with a matrix. Other cells are solved from event
/// to event and projected to cubics.
class BitNode {
  public:
    BitNode() : BitNode(1, 0, {}, 0) {}
    /// Creates the end of a section of this impedance, with a bit of this mass (0 for none), at the distance
    /// `gap` from the rock. Units are the dimensionless ones of Problem (problem.h).
    BitNode(double impedance, double mass, const BitRockLaw& law, double gap);

    /// Sets the widths of the cells (time steps) that follow, in units of t0; step() refers to them by index.
    void setWidths(const std::vector<double>& widths);

    /// Advances the bit by one cell (time step): computes the reflected wave b from the arriving wave g. The
    /// cell has the width number `index` and begins at `time`, in units of t0. If `jump` then says that all
    /// cells must be cut, nothing else is valid, and the step must be repeated after the cut.
    void step(const WaveCell& g, WaveCell& b, int index, double time, CutAt cutAt, CellJump& jump);
    /// State at a time within a cell (time step), and the reflected wave from the start of the cell to that
    /// time.
    struct Part {
        BitNodeState state;
        WaveCell leaving;
    };
    /// Returns the state after the fraction `share` (0 … 1) of the next cell (time step), without advancing
    /// the bit. g is the arriving wave, `index` the number of the cell's width, `time` its start in units of
    /// t0.
    Part partOfStep(const WaveCell& g, int index, double share, double time) const;

    /// Advances a bit without mass by one cell (time step) if it certainly stays away from the rock; the bit
    /// then reflects −g. Returns false and changes nothing if the bit may touch the rock, or has a mass.
    bool flyStep(const WaveCell& g, std::size_t index) {
        return m_mass == 0 && m_now.isApart() && fly(g, m_maps[index].width);
    }

    // Functions for a sequence of blows (drilling §4)

    /// Changes of the rock between two blows of a sequence.
    struct Turned {
        /// Growth of the residual penetration of the rock since the last blow, in units of I0/Zr.
        double penetration = 0;
        /// Elastic energy lost because a compressed rock was replaced by new rock [I0²/(Zr t0)].
        double lostEnergy = 0;
    };
    /// Starts the record of the next blow, and returns the changes of the rock since the last one. With
    /// `isFresh`, the bottom of the crater becomes the surface of new rock. A force that acts then continues
    /// along the first loading line; on a straight line, F becomes γF.
    Turned beginCycle(bool isFresh);
    /// Makes the record include force peaks below the largest force that the rock remembers; by default they
    /// are left out.
    void notePeaksOfCycles() { m_notesAllPeaks = true; }
    /// Sets the velocity of the bit mass, in units of F0/Zr, positive towards the rock.
    void setVelocity(double velocity) { m_now.velocity = velocity; }
    /// Returns the position of the bit relative to the bottom of the crater, in units of I0/Zr; positive into
    /// the rock, negative while apart.
    double placeFromBottom() const {
        return m_now.isApart() ? -m_now.distance : m_now.law.elasticWay(m_now.force);
    }
    /// Moves the bit to a position relative to the bottom of the crater (in I0/Zr, positive into the rock).
    /// The rock then remembers `largestForce` (in F0).
    void putAt(double placeFromBottom, double largestForce);

    /// Returns the impact force over the last cell (time step), in units of F0.
    const WaveCell& cellForce() const { return m_cellForce; }

    /// Returns the state of bit and rock after the last step.
    const BitNodeState& state() const { return m_now; }
    /// Restores an earlier state of bit and rock, with its record.
    void setState(const BitNodeState& state) { m_now = state; }
    /// Sets the list to which contact events are appended; nullptr for none.
    void setEvents(std::vector<ImpactEvent>* events) { m_events = events; }
    /// Returns the mass of the bit M/(Zr t0); 0 for none.
    double mass() const { return m_mass; }
    /// Returns the rate at which the force approaches 2g on the elastic line of the law, in units of 1/t0; g
    /// is the arriving wave. With a bit mass, it is the fastest rate of the oscillation.
    double fastestRate() const;
    /// Appends to `rates` all rate constants of the differential equations of bit and rock, in units of 1/t0.
    void addRates(std::vector<double>& rates) const;
    /// Returns the number of stretches between events that were computed in cells (time steps) with contact
    /// events, a measure of the work.
    long pieces() const { return m_pieces; }
    /// Returns the reason why an event could not be located; empty if there was no such failure.
    std::string_view failureReason() const { return m_failureReason; }

  private:
    struct CellMaps;
    struct EventPiece;
    /// Event that ends a stretch of a cell (time step) on one line of the bit–rock law, and the line after
    /// the event.
    struct LineEvent {
        Zero<double> zero;
        ContactLine line;
        /// Whether the event is a corner of the loading curve, so that the same kind of line continues with
        /// another slope.
        bool isCorner = false;
    };

    CellMaps mapsOf(double width) const;
    WaveCell follow(const WaveCell& g, double width, double time, CutAt cutAt, CellJump& jump);
    bool quietStep(const WaveCell& g, CellMaps& maps, double time, WaveCell& b);
    bool fly(const WaveCell& g, double width);
    EventPiece nextPiece(const WaveCell::Powers& g, double width, double from, double end) const;
    LineEvent nextEvent(const EventPiece& piece);
    void addContact(const EventPiece& piece, double end, double unit, double time);
    void moveAlong(const EventPiece& piece, double end, double time);
    void restAt(double wave, double time);
    void noteForce(double force, double time);
    void notePeak(double force, double time);
    void enter(const LineEvent& event, double time);
    void separate(double time);
    void touch(double time);
    double rateOn(ContactLine line) const { return m_now.law.slope(line) / m_impedance; }

    /// Linear maps over a cell (time step) for the force on one loading line of the bit–rock law, for one
    /// cell width.
    struct LineMaps {
        /// Index of the loading line for which the maps are, as in ContactLaw::loadingLine().
        std::size_t line = 0;
        /// Linear map of the force over a cell for a bit without mass (M = 0).
        Relaxation free;
        /// Linear map of velocity and force over a cell for a bit with mass (M > 0).
        Oscillation mass;
    };
    LineMaps mapsOfLine(double width) const;
    const LineMaps& loadingMaps(CellMaps& maps) const;

    struct CellMaps {
        double width = 0;
        /// Linear maps for the loading line of the bit–rock law that is now in use, at first the first line.
        LineMaps loading;
        /// Linear map of the force on the elastic line of the bit–rock law, for a bit without mass.
        Relaxation elastic;
        /// Linear map of the velocity of a bit with mass while bit and rock are apart.
        Relaxation apart;
        /// Linear map of velocity and force on the elastic line of the bit–rock law, for a bit with mass.
        Oscillation elasticMass;
    };

    double m_impedance;
    double m_mass;
    /// Factor 2/Z from an arriving wave to the velocity of a free end.
    double m_toSpeed;
    std::vector<CellMaps> m_maps;
    /// Linear maps for the cell widths that were set before the last setWidths(), reused if a width occurs
    /// again.
    std::vector<CellMaps> m_mapsBefore;
    ContactLaw<double> m_untouched{BitRockLaw{}};
    /// Residual penetration at the start of the present blow, in units of I0/Zr.
    double m_residual = 0;
    bool m_notesAllPeaks = false;
    BitNodeState m_now;
    WaveCell m_cellForce;
    std::vector<ImpactEvent>* m_events = nullptr;
    long m_pieces = 0;
    std::string_view m_failureReason;
};

}  // namespace drillwave
