// SPDX-License-Identifier: GPL-3.0-or-later
// The rear end of rod or string: hammer, machine body and damper on it, over many blows (drilling §2).
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/wave/drilling/drilling_problem.h"
#include "core/wave/network/wave_cell.h"

namespace drillwave {

/// Relative motion of machine, rear end and hammer.
struct RearState {
    double bodyVelocity = 0;  ///< v_b
    double velocityRest = 0;  ///< lost to its rounding: a heavy body keeps its momentum
    double stretch = 0;       ///< x_b − x_r
    double faceGap = 0;       ///< between hammer and rear end
    double faceForce = 0;     ///< P of faces with a stiffness
    bool touching = false;    ///< hammer and rear end
    bool released = true;     ///< nothing of the hammer counts until the next blow
    bool separated = false;   ///< once since the blow
    bool operator==(const RearState&) const = default;
};

/// Sums at the rear end since the blow.
struct RearSums {
    double faceImpulse = 0;    ///< ∫P dt, or ∫Fa dt
    double lateImpulse = 0;    ///< of that, after the first separation
    double damperImpulse = 0;  ///< ∫D dt
    double damperPeak = 0;     ///< largest D
    double forceWork = 0;      ///< ∫Fa v_r dt
    double feedWork = 0;       ///< ∫S v_b dt; of a constant force ∫S v_r dt
    double damperWork = 0;     ///< ∫D (v_b − v_r) dt
    double workOnRear = 0;     ///< ∫D v_r dt
};

/// P or Fa pushes the rear end of impedance Z2, and so does D:
///
///     f2 + b2 = P + D,   v_r = (P + D − 2 b2)/Z2
///     M v_b' = S − D,   x' = v_b − v_r,   D = max(0, S + κ x + ζ (v_b − v_r))                  (D1) (D2)
///
/// without a body D = S. The face of the hammer, P = f1 + b1 ≥ 0, is that of FaceNode.
class RearNode {
  public:
    /// Properties that are the same for all blows.
    struct Parts {
        double hammerImpedance = 0;  ///< Z1 of the last section of a hammer; 0 under a prescribed force
        double impedance = 1;        ///< Z2
        HammerFace face;
        std::optional<MachineBody> machine;
        /// Faces are separate when they part; else when they were apart for a cell.
        bool releasesAtOnce = true;
    };
    RearNode() = default;
    RearNode(const Parts& parts, std::span<const double> widths);

    /// A new piston touches the rear end, or a new force begins; S until the next one.
    void beginBlow(double meanForce);

    /// Over one part of a cell what pushes, P, and D. `f1` only counts for a hammer, `force`, Fa, without
    /// one, as long as it acts.
    struct Forces {
        WaveCell face, damper;
        WaveCell sum() const { return face + damper; }
    };
    Forces step(const WaveCell& f1, const WaveCell& b2, const WaveCell* force, std::size_t part) {
        if (!m_machine && !force && !hasHammer()) return {{}, WaveCell::constant(m_meanForce)};
        return push(f1, b2, force, part);
    }
    /// The sums are complete then; the rear end has moved so far since the blow.
    void endCycle(double duration, double rearMoved);

    const RearState& state() const { return m_now; }
    void setState(const RearState& state) { m_now = state; }
    const RearSums& sums() const { return m_sums; }
    double meanForce() const { return m_meanForce; }
    double mobility() const { return m_mobility; }  ///< 1/Z2
    /// In the stiffness of the faces, which goes with a hammer that still touches.
    double faceEnergy() const {
        return m_parts.face.stiffness ? m_now.faceForce * m_now.faceForce / (2 * *m_parts.face.stiffness) : 0;
    }
    double bodyMass() const { return m_machine ? m_machine->mass : 0; }
    /// Whether the waves of the hammer still matter.
    bool hasHammer() const { return m_parts.hammerImpedance > 0 && !m_now.released; }
    /// Why it cannot go on; empty when it can.
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
    /// Motion over a stretch of a cell: power series in 0 ≤ v ≤ 1.
    struct Piece {
        Modes modes;
        double from = 0, width = 1;
        int count = 0;
        Series push{}, damper{}, rear{}, body{}, stretch{}, gap{};
        Series margin{};  ///< positive until the damper lifts or presses
    };
    struct Inputs {
        Powers f1, b2, force;
        double width;
    };
    /// A whole cell in which the damper presses and nothing else changes, as a linear map of S, of the
    /// coefficients of q = P − 2 b2 from the third down to the first, of x and v_b, and of the mean of q:
    /// what is known last is last, so that little waits for it.
    struct PressingMap {
        static constexpr int inputs = WaveCell::count + 3;
        static constexpr int outputs = WaveCell::count + 1;  ///< D, and x behind it
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
    double m_fastest = 0;   ///< no rate at which anything follows is larger
    double m_mobility = 1;  ///< 1/Z2
    double m_ofMass = 0;    ///< 1/M
    double m_meanForce = 0;
    RearState m_now, m_before;  ///< at the blow
    RearSums m_sums;
    std::string_view m_failureReason;
};

}  // namespace drillwave
