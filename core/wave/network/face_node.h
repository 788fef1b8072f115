// SPDX-License-Identifier: GPL-3.0-or-later
// The face of the hammer on the string: it pushes and cannot pull (strings §4).
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/model/pulse_force.h"
#include "core/wave/network/relaxation.h"
#include "core/wave/network/wave_cell.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Sums and first events at the face up to a time.
struct FaceRecord {
    double impulse = 0;           ///< ∫P dt
    double impulseMoment = 0;     ///< ∫P t dt
    double work = 0;              ///< ∫Fa v dt of a force that replaces the hammer
    double firstRelease = -1;     ///< when P first fell to zero; negative: never
    double firstSeparation = -1;  ///< when the faces first moved apart; negative: never
};

/// State of the faces, and its history.
struct FaceNodeState {
    bool apart = false;
    bool released = false;  ///< for ever: no re-strike
    double gap = 0;
    double force = 0;  ///< P of faces with a stiffness
    FaceRecord record;
};

/// Two faces of impedances Z1 and Z2 with a gap h ≥ 0, w = 2(f1/Z1 + b2/Z2) how fast they would close if
/// nothing held them. Rigid: P = Z* w where they touch. With a stiffness: P' = kc (w − P/Z*). Apart: h' = −w.
class FaceNode {
  public:
    FaceNode() : FaceNode(1, 1, {}) {}
    FaceNode(double impedance1, double impedance2, const HammerFace& face);

    void setWidths(const std::vector<double>& widths);

    /// Arriving and leaving waves of one cell.
    struct Waves {
        const WaveCell &f1, &b2;
        WaveCell &b1, &f2;
    };
    /// Takes one cell of width number `index` that begins at `time` [t0]. If it sets a place to cut, the cell
    /// must be taken again in parts.
    void step(const Waves& waves, int index, double time, CutAt cutAt, CellJump& jump);
    /// State after the first `share` of that cell, and the waves that have left over that
    /// share.
    struct Part {
        FaceNodeState state;
        WaveCell f2, b1;
    };
    Part partOfStep(const WaveCell& f1, const WaveCell& b2, int index, double share, double time) const;

    const FaceNodeState& state() const { return m_now; }
    void setState(const FaceNodeState& state) { m_now = state; }
    std::optional<double> stiffness() const { return m_stiffness; }
    /// Returns the rate at which the force follows [1/t0]; 0 for rigid faces.
    double rate() const { return m_stiffness ? *m_stiffness / m_common : 0; }
    /// Pieces that cells with events took.
    long pieces() const { return m_pieces; }
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
    double m_of1, m_of2;  ///< 2/Z1, 2/Z2: from waves to the closing speed
    double m_common;      ///< Z* = Z1 Z2/(Z1 + Z2)
    std::optional<double> m_stiffness;
    bool m_restrike;
    std::vector<double> m_widths;
    std::vector<Relaxation> m_maps;  ///< of faces with a stiffness

    FaceNodeState m_now;
    long m_pieces = 0;
    std::string_view m_failureReason;
};

// A force on the rear end of a string, which does not feel what comes back (strings §4).

/// The rear end of a string of impedance Z under the force Fa: f = Fa − b, and it moves at v = (f − b)/Z.
/// Once the force is over, it is a face from which a hammer has parted for ever.
class ForceNode {
  public:
    /// `force` must outlive it.
    ForceNode(const PulseForce& force, double impedance) : m_force(&force), m_impedance(impedance) {}

    /// The wave that leaves over a cell of this width that begins at `time` [t0], while `back` arrives.
    WaveCell step(const WaveCell& back, double time, double width);

    const FaceNodeState& state() const { return m_now; }  ///< with the record of Fa
    void setState(const FaceNodeState& state) { m_now = state; }

  private:
    const PulseForce* m_force;
    double m_impedance;
    FaceNodeState m_now;
};

}  // namespace drillwave
