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

/// Impulse, peak force and contact times of the impact force up to a time, in the dimensionless units of
/// Problem (problem.h): times in t0, forces in F0, impulses in I0.
struct BitRecord {
    /// Impulse of the impact force, ∫F dt, in units of I0.
    double impulse = 0;
    /// First moment of the impact force over time, ∫F t dt, in units of I0 t0.
    double impulseMoment = 0;
    /// Largest impact force F between bit and rock, in units of F0.
    double peakForce = 0;
    /// Time t/t0 of the largest impact force.
    double peakTime = 0;
    /// Time t/t0 of the first contact of bit and rock; negative if there was none.
    double firstContact = -1;
    /// Time t/t0 at which the last contact of bit and rock began; negative if there was none.
    double lastContact = -1;
    /// Time t/t0 of the last separation of bit and rock; negative if there was none.
    double lastSeparation = -1;
    /// Sum of the durations of all contacts, in units of t0.
    double contactDuration = 0;
    /// Number of contacts of bit and rock that have begun.
    int contacts = 0;
};

/// State of bit and rock at one time, with impulse, peak force and times of contact so far. Lengths are in
/// I0/Zr, forces in F0, velocities in F0/Zr.
struct BitNodeState {
    /// Creates a bit at the surface of rock with the default bit–rock law.
    BitNodeState() : BitNodeState(ContactLaw<double>(BitRockLaw{}), 0) {}
    /// Creates a bit at the distance `gap` ≥ 0 [I0/Zr] from intact rock with the bit–rock law `untouched`.
    BitNodeState(const ContactLaw<double>& untouched, double gap) : law(untouched), distance(gap) {}

    /// Bit–rock law with its memory, the largest force so far.
    ContactLaw<double> law;
    /// Line of the bit–rock law on which bit and rock are now; `apart` if they do not touch.
    ContactLine line = ContactLine::apart;
    /// Impact force F of bit and rock, in units of F0; ≥ 0.
    double force = 0;
    /// Velocity of the bit mass in units of F0/Zr, positive towards the rock; not used without a bit mass.
    double velocity = 0;
    /// Distance from the bit to the rock or to the bottom of its crater, in units of I0/Zr; valid only while
    /// they are apart.
    double distance;
    /// Impulse, peak force and contact times so far.
    BitRecord record;

    /// Returns whether bit and rock are apart.
    bool isApart() const { return line == ContactLine::apart; }
    /// Returns the penetration U of the bit, from the original surface of the rock, in units of I0/Zr.
    double penetration() const {
        return isApart() ? law.residualPenetration() - distance : law.penetration(force);
    }
};

/// Front end of the string, with or without the mass M of a bit:
///
///     M U'' + Z U' + F(U) = 2g,    b = g − Z U'        (M = 0: U' = (2g − F)/Z, b = F − g)
///
/// U is the displacement of the bit, Z the impedance of the last section, g the arriving wave, and b the
/// reflected wave. F is the piecewise linear law of bit and rock with memory. A cell (time step) without a
/// contact event takes one product with a matrix. Other cells are solved from event to event and projected to
/// cubics.
class BitNode {
  public:
    BitNode() : BitNode(1, 0, {}, 0) {}
    /// Creates the front end of a string whose last section has the given impedance, with a bit of this mass
    /// (0 for none), at the distance `gap` from the rock. Units are the dimensionless ones of Problem
    /// (problem.h).
    BitNode(double impedance, double mass, const BitRockLaw& law, double gap);

    /// Sets the widths of the cells (time steps) that follow, in units of t0; step() selects one of them by
    /// its index.
    void setWidths(const std::vector<double>& widths);

    /// Advances the bit by one cell (time step) and computes the reflected wave `b` from the arriving wave
    /// `g`. `index` selects the width of the cell from those of setWidths(); `time` is its start in t0.
    /// `jump` reports an event at which all cells should be divided. The caller then restores the earlier
    /// state, divides the cells and repeats the step.
    void step(const WaveCell& g, WaveCell& b, int index, double time, CutAt cutAt, CellJump& jump);
    /// State of bit and rock at a time within a cell (time step), and the reflected wave from the start of
    /// the cell to that time.
    struct Part {
        BitNodeState state;
        WaveCell leaving;
    };
    /// Returns the state after the fraction `share` (0 … 1) of the next cell (time step), without advancing
    /// the bit. g is the arriving wave. `index` selects the width of the cell from those of setWidths();
    /// `time` is its start in t0.
    Part partOfStep(const WaveCell& g, int index, double share, double time) const;

    /// Advances a bit without mass by one cell (time step) if it certainly stays away from the rock. The bit
    /// then reflects the arriving wave `g` as −g. Otherwise, or if the bit has a mass, returns false and
    /// changes nothing. `index` selects the width of the cell from those of setWidths().
    bool flyStep(const WaveCell& g, std::size_t index) {
        return m_mass == 0 && m_now.isApart() && fly(g, m_maps[index].width);
    }

    // Functions for a sequence of blows (drilling §4)

    /// Changes of the rock between two blows of a sequence.
    struct Turned {
        /// Growth of the residual penetration of the rock since the last blow, in units of I0/Zr.
        double penetration = 0;
        /// Elastic energy of compressed rock that is lost because new rock takes its place under the bit
        /// [I0²/(Zr t0)].
        double lostEnergy = 0;
    };
    /// Starts a new record (impulse, peak force, times) for the next blow, and returns how the rock has
    /// changed since the previous one. With `isFresh`, the bit then acts on new rock with its surface at the
    /// bottom of the crater. A force F that acts at this time continues along the first loading line; on rock
    /// with one straight loading line it becomes γF.
    Turned beginCycle(bool isFresh);
    /// Makes the record include force peaks during elastic reloading, which are below the largest force so
    /// far on this rock. By default they are left out.
    void notePeaksOfCycles() { m_notesAllPeaks = true; }
    /// Sets the velocity of the bit mass, in units of F0/Zr, positive towards the rock.
    void setVelocity(double velocity) { m_now.velocity = velocity; }
    /// Returns the position of the bit relative to the bottom of the crater, in units of I0/Zr; positive into
    /// the rock, negative while apart.
    double placeFromBottom() const {
        return m_now.isApart() ? -m_now.distance : m_now.law.elasticWay(m_now.force);
    }
    /// Sets the state of rock and bit. The rock has been loaded up to `largestForce` [F0]; the bit is at
    /// `placeFromBottom` [I0/Zr] from the bottom of the resulting crater, positive into the rock.
    void putAt(double placeFromBottom, double largestForce);

    /// Returns the impact force over the last computed cell (time step), in units of F0.
    const WaveCell& cellForce() const { return m_cellForce; }

    /// Returns the state of bit and rock after the last step.
    const BitNodeState& state() const { return m_now; }
    /// Restores an earlier state of bit and rock, including impulse, peak force and times so far.
    void setState(const BitNodeState& state) { m_now = state; }
    /// Sets the list to which contact events are appended; nullptr for none.
    void setEvents(std::vector<ImpactEvent>* events) { m_events = events; }
    /// Returns the mass of the bit M/(Zr t0); 0 for none.
    double mass() const { return m_mass; }
    /// Returns the rate [1/t0] at which the impact force approaches 2g on the elastic line (unloading and
    /// reloading) of the bit–rock law; g is the arriving wave. With a bit mass, it is the fastest rate of the
    /// oscillation.
    double fastestRate() const;
    /// Appends to `rates` all rate constants of the differential equations of bit and rock, in units of 1/t0.
    void addRates(std::vector<double>& rates) const;
    /// Returns the number of stretches between contact events computed so far, in cells (time steps) with
    /// such events. It measures their work.
    long pieces() const { return m_pieces; }
    /// Returns the reason why the time of a contact event could not be found; empty if there was no such
    /// failure.
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

    /// Linear maps that advance force and velocity of the bit over one cell (time step) on one loading line
    /// of the bit–rock law.
    struct LineMaps {
        /// Index of the loading line to which the maps apply, as in ContactLaw::loadingLine().
        std::size_t line = 0;
        /// Linear map that gives the force of a bit without mass over one cell (time step).
        Relaxation free;
        /// Linear map that gives velocity and force of a bit with mass over one cell (time step).
        Oscillation mass;
    };
    LineMaps mapsOfLine(double width) const;
    const LineMaps& loadingMaps(CellMaps& maps) const;

    struct CellMaps {
        double width = 0;
        /// Linear maps over one cell (time step) for the loading line of the bit–rock law that is now in use,
        /// at first the first line.
        LineMaps loading;
        /// Linear map that gives the force of a bit without mass over one cell (time step) on the elastic
        /// line of the bit–rock law.
        Relaxation elastic;
        /// Linear map that gives the velocity of a bit with mass over one cell (time step) while bit and rock
        /// are apart.
        Relaxation apart;
        /// Linear map that gives velocity and force of a bit with mass over one cell (time step) on the
        /// elastic line of the bit–rock law.
        Oscillation elasticMass;
    };

    double m_impedance;
    double m_mass;
    /// Factor 2/Z that turns an arriving wave into the velocity of a free bit; Z is the impedance of the last
    /// section.
    double m_toSpeed;
    std::vector<CellMaps> m_maps;
    /// Linear maps over one cell (time step) for the widths that were set before the last setWidths(). They
    /// are reused if a width occurs again.
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
