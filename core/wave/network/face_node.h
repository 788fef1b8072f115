// SPDX-License-Identifier: GPL-3.0-or-later
// Contact of hammer and string: the faces can push each other and cannot pull (strings §4).
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/model/pulse_force.h"
#include "core/wave/network/relaxation.h"
#include "core/wave/network/wave_cell.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Impulse, work and first separation of the contact force P of hammer and string, up to a time. Units are
/// the dimensionless ones of Problem (problem.h).
struct FaceRecord {
    /// Impulse of the contact force, ∫P dt, in units of I0.
    double impulse = 0;
    /// First moment of the contact force over time, ∫P t dt, in units of I0 t0.
    double impulseMoment = 0;
    /// Work of a prescribed force that replaces the hammer, ∫Fa v dt [I0²/(Zr t0)].
    double work = 0;
    /// Time t/t0 at which the contact force first fell to zero; negative if it did not.
    double firstRelease = -1;
    /// Time t/t0 at which hammer and string first moved apart; negative if they did not.
    double firstSeparation = -1;
};

/// State of the contact of hammer and string at one time, with impulse and first separation so far.
struct FaceNodeState {
    /// Whether hammer and string are apart.
    bool apart = false;
    /// Whether hammer and string have separated for good: true once they have separated and further strikes
    /// are disabled.
    bool released = false;
    /// Gap between hammer and string, in units of I0/Zr; ≥ 0.
    double gap = 0;
    /// Contact force P/F0 of faces with a contact stiffness; not used for rigid faces.
    double force = 0;
    /// Impulse and first separation of the contact so far.
    FaceRecord record;
};

/// Contact of the two faces of hammer (impedance Z1) and string (Z2), with a gap h ≥ 0. The waves f1 (in the
/// hammer) and b2 (in the string) arrive. If no force acted between the faces, they would approach at the
/// velocity w = 2(f1/Z1 + b2/Z2). Rigid faces in contact: P = Z* w with Z* = Z1 Z2/(Z1 + Z2). Faces with a
/// contact stiffness: P' = kc (w − P/Z*). Apart: h' = −w.
class FaceNode {
  public:
    FaceNode() : FaceNode(1, 1, {}) {}
    /// Creates the contact between a hammer of `impedance1` and a string of `impedance2`. `face` holds its
    /// stiffness and whether it may close again.
    FaceNode(double impedance1, double impedance2, const HammerFace& face);

    /// Sets the widths of the cells (time steps) that follow, in units of t0; step() selects one of them by
    /// its index.
    void setWidths(const std::vector<double>& widths);

    /// Waves of one cell (time step) at the contact. The waves f1 (in the hammer) and b2 (in the string)
    /// arrive; b1 and f2 leave.
    struct Waves {
        const WaveCell &f1, &b2;
        WaveCell &b1, &f2;
    };
    /// Advances the contact by one cell (time step), and writes the leaving waves. `index` selects the width
    /// of the cell from those of setWidths(); `time` is its start in t0. `jump` reports an event at which all
    /// cells should be divided. The caller then restores the earlier state, divides the cells and repeats the
    /// step.
    void step(const Waves& waves, int index, double time, CutAt cutAt, CellJump& jump);
    /// State of the contact of hammer and string at a time within a cell (time step), and the leaving waves
    /// from the start of the cell to that time.
    struct Part {
        FaceNodeState state;
        WaveCell f2, b1;
    };
    /// Returns the state after the fraction `share` (0 … 1) of the next cell (time step), without advancing
    /// the contact. f1 and b2 are the arriving waves. `index` selects the width of the cell from those of
    /// setWidths(); `time` is its start in t0.
    Part partOfStep(const WaveCell& f1, const WaveCell& b2, int index, double share, double time) const;

    /// Returns the state of the contact after the last step.
    const FaceNodeState& state() const { return m_now; }
    /// Restores an earlier state of the contact of hammer and string, including its impulse and times so far.
    void setState(const FaceNodeState& state) { m_now = state; }
    /// Returns the contact stiffness κc = kc t0/Zr; nullopt for rigid faces.
    std::optional<double> stiffness() const { return m_stiffness; }
    /// Returns the rate at which the contact force follows the waves, in units of 1/t0; 0 for rigid faces.
    double rate() const { return m_stiffness ? *m_stiffness / m_common : 0; }
    /// Returns the number of stretches between contact events computed so far, in cells (time steps) with
    /// such events. It measures their work.
    long pieces() const { return m_pieces; }
    /// Returns the reason why the time of a contact event could not be found; empty if there was no such
    /// failure.
    std::string_view failureReason() const { return m_failureReason; }

  private:
    struct EventPiece;

    WaveCell closingSpeed(const WaveCell& f1, const WaveCell& b2) const;
    bool staysApart(const WaveCell& f1, const WaveCell& b2, double width);
    bool quietForce(const WaveCell& w, int index, WaveCell& force);
    EventPiece nextPiece(const WaveCell::Powers& w, double width, double from, double end) const;
    EventPiece stretch(const WaveCell::Powers& w, double width, double from, double end) const;
    WaveCell follow(const WaveCell& w, double width, double time, CutAt cutAt, CellJump& jump);
    void add(const WaveCell& force, double width, double time);
    void noteOpening(const WaveCell& w, double width, double time);
    void separate(double time);

    double m_impedance1, m_impedance2;
    /// Factors 2/Z1 and 2/Z2 that turn the waves arriving in hammer and string into the velocity at which the
    /// faces approach.
    double m_of1, m_of2;
    /// Combined impedance Z* = Z1 Z2/(Z1 + Z2) of hammer (Z1) and string (Z2) at their contact.
    double m_common;
    std::optional<double> m_stiffness;
    bool m_restrike;
    std::vector<double> m_widths;
    /// Linear maps of the contact force over a cell, one for each cell width; used for faces with a contact
    /// stiffness.
    std::vector<Relaxation> m_maps;

    FaceNodeState m_now;
    long m_pieces = 0;
    std::string_view m_failureReason;
};

// Prescribed force on the rear end of a string, which reflected waves do not change (strings §4)

/// Rear end of a string of impedance Z under the prescribed force Fa. The wave b arrives, the wave f leaves:
/// f = Fa − b, v = (f − b)/Z. After the end of the force, its state is that of a face from which the hammer
/// has separated for ever.
class ForceNode {
  public:
    /// Creates the rear end of a section of this impedance, on which the prescribed force `force` acts.
    /// `force` must outlive the object.
    ForceNode(const PulseForce& force, double impedance) : m_force(&force), m_impedance(impedance) {}

    /// Returns the wave f towards the rock over a cell (time step) of the given width that begins at `time`
    /// [t0], while the wave `back` arrives.
    WaveCell step(const WaveCell& back, double time, double width);

    /// Returns the state of the rear end, including impulse and work of the force so far.
    const FaceNodeState& state() const { return m_now; }
    /// Restores an earlier state of the rear end, including impulse and work of the force so far.
    void setState(const FaceNodeState& state) { m_now = state; }

  private:
    const PulseForce* m_force;
    double m_impedance;
    FaceNodeState m_now;
};

}  // namespace drillwave
