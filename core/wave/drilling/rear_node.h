// SPDX-License-Identifier: GPL-3.0-or-later
// Rear end of rod or string with hammer, machine body and damper, over many blows (drilling §2).
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/wave/drilling/drilling_problem.h"
#include "core/wave/network/wave_cell.h"

namespace drillwave {

/// State of machine body, rear end and hammer at one time: velocity, relative positions and contact, in the
/// dimensionless units of Problem (problem.h).
struct RearState {
    /// Velocity v_b of the machine body, in units of F0/Zr, positive towards the rock.
    double bodyVelocity = 0;
    /// Rounding error of the velocity v_b, in units of F0/Zr. It is subtracted from the next change of
    /// velocity, so that the momentum of a heavy body is conserved.
    double velocityRest = 0;
    /// Position of the machine body relative to the rear end, x = x_b − x_r, in units of I0/Zr.
    double stretch = 0;
    /// Gap between hammer and rear end, in units of I0/Zr; ≥ 0.
    double faceGap = 0;
    /// Contact force P/F0 of hammer and string if their faces have a contact stiffness; 0 for rigid faces.
    double faceForce = 0;
    /// Whether the hammer touches the rear end.
    bool touching = false;
    /// Whether the hammer no longer acts on the string until the next blow.
    bool released = true;
    /// Whether hammer and rear end have separated since the blow.
    bool separated = false;
    bool operator==(const RearState&) const = default;
};

/// Impulses, work and largest damper force at the rear end since the last blow, in the dimensionless units of
/// Problem (problem.h).
struct RearSums {
    /// Impulse ∫P dt of the hammer, or ∫Fa dt of a prescribed force, in units of I0.
    double faceImpulse = 0;
    /// Part of faceImpulse after the first separation of the hammer, in units of I0.
    double lateImpulse = 0;
    /// Impulse of the damper, ∫D dt, in units of I0.
    double damperImpulse = 0;
    /// Largest damper force D, in units of F0.
    double damperPeak = 0;
    /// Work ∫Fa v_r dt of a prescribed force [I0²/(Zr t0)].
    double forceWork = 0;
    /// Work ∫S v_b dt of the mean feed force S [I0²/(Zr t0)]; for a constant force, ∫S v_r dt.
    double feedWork = 0;
    /// Work done on the damper and its spring, ∫D (v_b − v_r) dt [I0²/(Zr t0)].
    double damperWork = 0;
    /// Work of the damper force on the rear end, ∫D v_r dt [I0²/(Zr t0)].
    double workOnRear = 0;
};

/// Rear end of a string of impedance Z2, on which the hammer (force P) or a prescribed force Fa acts, and the
/// damper (force D). v_r is the velocity of the rear end, v_b that of the machine body, x = x_b − x_r. The
/// wave f2 leaves into the string, the wave b2 arrives from it:
///
///     f2 + b2 = P + D,   v_r = (P + D − 2 b2)/Z2
///
///     M v_b' = S − D,   x' = v_b − v_r,   D = max(0, S + κ x + ζ (v_b − v_r))                  (D1) (D2)
///
/// S is the mean force of the feed. Without a machine body, D = S. The contact force P = f1 + b1 ≥ 0 of the
/// hammer follows the laws of FaceNode.
class RearNode {
  public:
    /// Properties of the rear end that are the same for all blows, in the dimensionless units of Problem
    /// (problem.h).
    struct Parts {
        /// Impedance Z1 of the last section of the hammer; 0 for a prescribed force.
        double hammerImpedance = 0;
        /// Impedance Z2 of the first section of the string.
        double impedance = 1;
        /// Contact of hammer and string: its stiffness, and whether the hammer may hit the string again.
        HammerFace face;
        /// Machine body with damper; nullopt if a constant force presses on the rear end instead.
        std::optional<MachineBody> machine;
        /// Whether hammer and string count as separated as soon as the contact force is zero; otherwise only
        /// after a whole time step (cell) without contact.
        bool releasesAtOnce = true;
    };
    RearNode() = default;
    /// Creates the rear end at rest. `widths` are the widths of the parts of a cell (time step), in units of
    /// t0.
    RearNode(const Parts& parts, std::span<const double> widths);

    /// Starts a blow: a new hammer touches the rear end, or a new prescribed force begins. `meanForce` is the
    /// mean force S of the feed until the next blow, in units of F0.
    void beginBlow(double meanForce);

    /// Forces on the rear end over one time step, in units of F0: that of the hammer or the prescribed force
    /// (`face`), and that of the damper (`damper`).
    struct Forces {
        WaveCell face, damper;
        /// Returns the total force on the rear end, in units of F0.
        WaveCell sum() const { return face + damper; }
    };
    /// Advances the struck end of the string by one time step and returns the forces on it. The wave `f1`
    /// arrives through the hammer, the wave `b2` through the string. `force` is the prescribed force; null if
    /// there is none or it has ended. `part` is the index of this time step among the parts of its cell.
    Forces step(const WaveCell& f1, const WaveCell& b2, const WaveCell* force, std::size_t part) {
        if (!m_machine && !force && !hasHammer()) return {{}, WaveCell::constant(m_meanForce)};
        return push(f1, b2, force, part);
    }
    /// Completes the impulses and the work of sums() at the end of an interval between two blows. `duration`
    /// [t0] is the length of the interval, `rearMoved` [I0/Zr] the displacement of the rear end in it.
    void endCycle(double duration, double rearMoved);

    /// Returns the state of machine, rear end and hammer after the last time step.
    const RearState& state() const { return m_now; }
    /// Restores a state of machine, rear end and hammer.
    void setState(const RearState& state) { m_now = state; }
    /// Returns impulses and work at the rear end since the last blow. They are complete after endCycle().
    const RearSums& sums() const { return m_sums; }
    /// Returns the mean force S of the feed in the present interval, in units of F0.
    double meanForce() const { return m_meanForce; }
    /// Returns the velocity of the rear end per unit of force, 1/Z2 with the impedance Z2 of the first
    /// section, in units of 1/Zr.
    double mobility() const { return m_mobility; }
    /// Returns the elastic energy in the contact stiffness of the faces [I0²/(Zr t0)]. If the hammer still
    /// touches at the next blow, this energy is lost, because a new hammer replaces it.
    double faceEnergy() const {
        return m_parts.face.stiffness ? m_now.faceForce * m_now.faceForce / (2 * *m_parts.face.stiffness) : 0;
    }
    /// Returns the mass of the machine body, M/(Zr t0); 0 if there is none.
    double bodyMass() const { return m_machine ? m_machine->mass : 0; }
    /// Returns whether the string is struck by a hammer whose waves still act on the string.
    bool hasHammer() const { return m_parts.hammerImpedance > 0 && !m_now.released; }
    /// Returns the reason why the computation failed; empty if it did not.
    std::string_view failureReason() const { return m_failureReason; }

  private:
    static constexpr int capacity = 16;
    using Series = std::array<double, capacity>;
    using Powers = WaveCell::Powers;
    enum class Face { given, touching, apart };
    struct Modes {
        bool pressing = true;
        Face face = Face::given;
    };
    /// Motion of rear end, machine and hammer during a part of a time step (cell) in which no contact opens
    /// or closes. Its series are polynomials in v, which runs from 0 to 1 during this part.
    struct Piece {
        Modes modes;
        double from = 0, width = 1;
        int count = 0;
        Series push{}, damper{}, rear{}, body{}, stretch{}, gap{};
        /// Damper force while the damper presses, its negative value while it is lifted off; a series in v.
        /// It is positive until the next event, at its zero: the damper lifts off or presses again.
        Series margin{};
    };
    struct Inputs {
        Powers f1, b2, force;
        double width;
    };
    /// Linear map over a whole cell (time step) in which the damper presses and no contact changes. It gives
    /// the damper force during the cell, and the position x at its end. Its inputs, in this order, are the
    /// feed force S; Legendre coefficients 3, 2 and 1 of q = P − 2 b2; x; v_b; the mean of q. Inputs that are
    /// known late come last, so that most of the products can be computed before.
    struct PressingMap {
        static constexpr int inputs = WaveCell::count + 3;
        static constexpr int outputs = WaveCell::count + 1;  ///< number of outputs: D, and x at the end
        std::array<std::array<double, outputs>, inputs> of{};
    };

    Piece pieceOf(const Inputs& in, const Modes& modes, double from, double end, const RearState& start,
                  double meanForce) const;
    int termsOf(double rate) const;
    Piece nextPiece(const Inputs& in, double from, double end) const;
    bool isConsistent(const Piece& piece) const;
    PressingMap pressingMap(double width) const;
    void accelerate(double velocityChange);
    bool quietStep(const WaveCell& b2, double width, std::size_t part, Forces& forces);
    bool staysApart(const WaveCell& f1, const WaveCell& b2, double width);
    Forces follow(const Inputs& in);
    void separate();
    void addDamper(const Piece& piece, double end, double unit);
    Forces push(const WaveCell& f1, const WaveCell& b2, const WaveCell* force, std::size_t part);

    Parts m_parts;
    std::optional<MachineBody> m_machine;
    std::vector<double> m_widths;
    std::vector<PressingMap> m_maps;
    /// Upper bound of the rate constants (inverse time constants) of the motion of the rear end, in units of
    /// 1/t0. It limits the time over which one power series is used.
    double m_fastest = 0;
    double m_mobility = 1;  ///< velocity of the rear end per force, 1/Z2
    double m_ofMass = 0;    ///< reciprocal mass 1/M of the machine body
    double m_meanForce = 0;
    RearState m_now, m_before;  ///< present state, and that at the last blow
    RearSums m_sums;
    std::string_view m_failureReason;
};

}  // namespace drillwave
