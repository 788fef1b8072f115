// SPDX-License-Identifier: GPL-3.0-or-later
// Wave that returns to a gauge: the sections between the gauge's section and the rock, and the rock.
#pragma once

#include <cstddef>
#include <vector>

#include "core/study/identify/rock_response.h"

namespace drillwave {

/// A uniform section towards the rock, or a piece of a cone.
struct EndSection {
    double impedance = 1;    ///< Z [N s/m], > 0
    double transitTime = 0;  ///< L/c [s], > 0
    double passing = 1;      ///< share of an amplitude that is left after one way, (0, 1]
    std::size_t source = 0;  ///< section of the string towards the bit that it is a piece of, from 0
};

/// Joint at the far end of a section: a lumped mass, a loss (strings §3).
struct EndJoint {
    double mass = 0;     ///< [kg]
    double passing = 1;  ///< √(1 − η)
};

/// Everything between the end of the gauge's section and the rock, in SI units. The near end takes f and lets
/// b out: nothing returns from behind the gauge in the time that is looked at.
struct RockEnd {
    double impedance = 1;              ///< of the gauge's section [N s/m]
    std::vector<EndSection> sections;  ///< towards the rock; none: the gauge's section ends at the rock
    std::vector<EndJoint> joints;      ///< one in front of each section
    double bitMass = 0;                ///< [kg]
    bool barBehind = false;            ///< a specimen before a bar like that of the gauge

    double transitTime() const;  ///< of all sections, one way [s]
};

/// Returns the wave b at the end of the gauge's section where f arrives there, both at times n·step. Keeps
/// its workspace from run to run.
class ChainModel {
  public:
    /// `step` > 0 [s]; sections shorter than a step are taken as long as one.
    ChainModel(const RockEnd& end, double step) : m_end(&end), m_step(step) {}

    /// The force on the rock and the penetration are kept where `keepsRock`.
    void run(const RockEnd& end, const TrialRock& rock, const std::vector<double>& f, std::size_t count,
             bool keepsRock = false);
    void run(const TrialRock& rock, const std::vector<double>& f, std::size_t count, bool keepsRock = false) {
        run(*m_end, rock, f, count, keepsRock);
    }

    const std::vector<double>& returned() const { return m_returned; }        ///< b [N]
    const std::vector<double>& rockForce() const { return m_force; }          ///< F [N]
    const std::vector<double>& penetration() const { return m_penetration; }  ///< U [m]
    double largestForce() const { return m_largestForce; }                    ///< of the last run [N]
    double lastForce() const { return m_lastForce; }  ///< at the end of the last run [N]

  private:
    struct Line {
        std::vector<double> forward, backward;  ///< what enters at the near and at the far end
        double weights[4];
        std::size_t whole;  ///< steps between now and the second of the four samples read
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
