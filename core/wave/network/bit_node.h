// SPDX-License-Identifier: GPL-3.0-or-later
// The bit on the rock: the wave that arrives, the force of the rock, the wave that leaves (strings §5).
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

/// Sums and extremes at the bit up to a time.
struct BitRecord {
    double impulse = 0;          ///< ∫F dt
    double impulseMoment = 0;    ///< ∫F t dt
    double peakForce = 0;        ///< largest F
    double peakTime = 0;         ///< when
    double firstContact = -1;    ///< when; negative: never
    double lastContact = -1;     ///< when the last one began; negative: never
    double lastSeparation = -1;  ///< when; negative: never
    double contactDuration = 0;  ///< summed over contacts
    int contacts = 0;
};

/// State of bit and rock, and its history.
struct BitNodeState {
    BitNodeState() : BitNodeState(ContactLaw<double>(BitRockLaw{}), 0) {}
    BitNodeState(const ContactLaw<double>& untouched, double gap) : law(untouched), distance(gap) {}

    ContactLaw<double> law;  ///< with the memory of the rock
    ContactLine line = ContactLine::apart;
    double force = 0;
    double velocity = 0;  ///< of the bit mass
    double distance;      ///< distance from the present face of the rock, while apart
    BitRecord record;

    bool isApart() const { return line == ContactLine::apart; }
    /// Returns U, from the undisturbed face of the rock.
    double penetration() const {
        return isApart() ? law.residualPenetration() - distance : law.penetration(force);
    }
};

/// End of the string, with or without the mass of a bit:
///
///     M U'' + Z U' + F(U) = 2g,    b = g − Z U'        (M = 0: U' = (2g − F)/Z, b = F − g)
///
/// F of straight lines with memory. A cell without an event is one product with a matrix; otherwise it is
/// followed from event to event and projected.
class BitNode {
  public:
    BitNode() : BitNode(1, 0, {}, 0) {}
    BitNode(double impedance, double mass, const BitRockLaw& law, double gap);

    /// Sets the widths of the cells that follow [t0], in turn.
    void setWidths(const std::vector<double>& widths);

    /// Takes one cell of width number `index` that begins at `time` [t0]: from the arriving wave g to the
    /// leaving wave b. If it sets a place to cut, the cell must be taken again in parts.
    void step(const WaveCell& g, WaveCell& b, int index, double time, CutAt cutAt, CellJump& jump);
    /// State after the first `share` of that cell, and the wave that has left over that share.
    struct Part {
        BitNodeState state;
        WaveCell leaving;
    };
    Part partOfStep(const WaveCell& g, int index, double share, double time) const;

    /// Takes a step of a bit without mass that stays away from the rock: −g leaves. False, and nothing done,
    /// if it may not stay away.
    bool flyStep(const WaveCell& g, std::size_t index) {
        return m_mass == 0 && m_now.isApart() && fly(g, m_maps[index].width);
    }

    // Many blows (drilling §4)

    /// Changes of the rock between two cycles.
    struct Turned {
        double penetration = 0;  ///< growth of its residual penetration
        double lostEnergy = 0;   ///< of a rock that was pressed, and then replaced
    };
    /// Starts a new record. On new rock the bottom of the crater is the new face, and a force that presses
    /// continues along the first line: F becomes γF on a straight one.
    Turned beginCycle(bool isFresh);
    /// Records peaks also below the largest force that the rock remembers.
    void notePeaksOfCycles() { m_notesAllPeaks = true; }
    void setVelocity(double velocity) { m_now.velocity = velocity; }
    /// Returns U from the bottom of the crater, negative while apart.
    double placeFromBottom() const {
        return m_now.isApart() ? -m_now.distance : m_now.law.elasticWay(m_now.force);
    }
    /// Moves the bit there, on a rock that remembers this largest force.
    void putAt(double placeFromBottom, double largestForce);

    /// Returns F over the cell that was stepped last.
    const WaveCell& cellForce() const { return m_cellForce; }

    const BitNodeState& state() const { return m_now; }
    void setState(const BitNodeState& state) { m_now = state; }
    /// Records events there; nullptr: nowhere.
    void setEvents(std::vector<ImpactEvent>* events) { m_events = events; }
    double mass() const { return m_mass; }
    /// Returns the rate at which the force follows on the elastic line [1/t0].
    double fastestRate() const;
    /// Adds all rates at which the force follows [1/t0].
    void addRates(std::vector<double>& rates) const;
    /// Returns the number of pieces in cells with events.
    long pieces() const { return m_pieces; }
    /// Returns why the node could not go on; empty if it could.
    std::string_view failureReason() const { return m_failureReason; }

  private:
    struct CellMaps;
    struct EventPiece;
    /// Early end of a piece, and the line that follows.
    struct LineEvent {
        Zero<double> zero;
        ContactLine line;
        bool isCorner = false;  ///< the same line continues, with another slope
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

    /// Response of the force along a loading line.
    struct LineMaps {
        std::size_t line = 0;  ///< ContactLaw::loadingLine()
        Relaxation free;       ///< M = 0
        Oscillation mass;      ///< M > 0
    };
    LineMaps mapsOfLine(double width) const;
    const LineMaps& loadingMaps(CellMaps& maps) const;

    struct CellMaps {
        double width = 0;
        LineMaps loading;         ///< of one line, at first the first one
        Relaxation elastic;       ///< of the force, M = 0
        Relaxation apart;         ///< of the velocity, M > 0
        Oscillation elasticMass;  ///< of both
    };

    double m_impedance;
    double m_mass;
    double m_toSpeed;  ///< 2/Z: of a free end, from the wave that arrives
    std::vector<CellMaps> m_maps;
    std::vector<CellMaps> m_mapsBefore;  ///< only for its memory
    ContactLaw<double> m_untouched{BitRockLaw{}};
    double m_residual = 0;  ///< penetration when the cycle began
    bool m_notesAllPeaks = false;
    BitNodeState m_now;
    WaveCell m_cellForce;
    std::vector<ImpactEvent>* m_events = nullptr;
    long m_pieces = 0;
    std::string_view m_failureReason;
};

}  // namespace drillwave
