// SPDX-License-Identifier: GPL-3.0-or-later
// Model of the wave that returns to a gauge: the sections between gauge and rock, their joints, and the rock.
#pragma once

#include <cstddef>
#include <vector>

#include "core/study/identify/rock_response.h"

namespace drillwave {

/// Uniform section between the gauge's section and the rock, or one uniform piece of a conical section.
struct EndSection {
    double impedance = 1;    ///< characteristic impedance Z [N s/m], > 0
    double transitTime = 0;  ///< one-way transit time L/c [s], > 0
    /// Share of a wave amplitude that remains after one passage through the section, in (0, 1]; 1 without
    /// attenuation.
    double passing = 1;
    /// Index of the section of the string to which this piece belongs, counted from 0 from the gauge towards
    /// the bit.
    std::size_t source = 0;
};

/// Joint between two sections, with a lumped mass and an energy loss η (strings §3).
struct EndJoint {
    double mass = 0;     ///< lumped mass [kg]
    double passing = 1;  ///< share of a wave amplitude that the joint transmits, √(1 − η)
};

/// Model of everything between the section with the gauge and the rock, in SI units. The incident wave f
/// enters at its near end, and the returning wave b leaves there. Waves returning from the hammer side of the
/// gauge arrive too late to matter.
struct RockEnd {
    double impedance = 1;  ///< characteristic impedance Z of the gauge's section [N s/m]
    /// Sections between the gauge's section and the rock, in this order; empty if the gauge's section ends at
    /// the rock.
    std::vector<EndSection> sections;
    std::vector<EndJoint> joints;  ///< joints, one at the near end of each section
    double bitMass = 0;            ///< lumped mass of the bit [kg]
    /// Whether the rock is a specimen in front of a second bar like that of the gauge.
    bool barBehind = false;

    /// Returns the one-way transit time through all sections [s].
    double transitTime() const;
};

/// Solver for the wave b that returns from the rock to the end of the gauge's section when the wave f arrives
/// there. Both are sampled at times n·step. Buffers are reused between runs.
class ChainModel {
  public:
    /// Requires a time step `step` > 0 [s]. Sections shorter than a step are treated as one step long.
    ChainModel(const RockEnd& end, double step) : m_end(&end), m_step(step) {}

    /// Computes the returning wave for the incident wave `f` [N] over `count` steps. With `keepsRock`, also
    /// stores the force on the rock and the penetration.
    void run(const RockEnd& end, const TrialRock& rock, const std::vector<double>& f, std::size_t count,
             bool keepsRock = false);
    void run(const TrialRock& rock, const std::vector<double>& f, std::size_t count, bool keepsRock = false) {
        run(*m_end, rock, f, count, keepsRock);
    }

    /// Returns the returning wave b [N] of the last run.
    const std::vector<double>& returned() const { return m_returned; }
    /// Returns the force F on the rock [N] of the last run.
    const std::vector<double>& rockForce() const { return m_force; }
    /// Returns the penetration U [m] of the last run.
    const std::vector<double>& penetration() const { return m_penetration; }
    /// Returns the largest force on the rock during the last run [N].
    double largestForce() const { return m_largestForce; }
    /// Returns the force on the rock at the end of the last run [N].
    double lastForce() const { return m_lastForce; }

  private:
    struct Line {
        std::vector<double> forward, backward;  ///< waves that enter at the near and at the far end [N]
        double weights[4];
        /// Number of whole time steps from the second of the four interpolated samples until now.
        std::size_t whole;
        double passing;
    };
    static double arriving(const Line& line, const std::vector<double>& wave, std::size_t n);

    const RockEnd* m_end;
    double m_step;
    std::vector<Line> m_lines;
    std::vector<double> m_velocities;
    std::vector<double> m_returned, m_force, m_penetration;
    double m_largestForce = 0;
    double m_lastForce = 0;
};

}  // namespace drillwave
