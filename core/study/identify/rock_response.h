// SPDX-License-Identifier: GPL-3.0-or-later
// Force on the rock under an incident wave that is linear over each time step, for a trial law in SI units.
#pragma once

#include <cstddef>
#include <vector>

namespace drillwave {

/// A loading line of a trial law: from this force on the force rises with this slope.
struct TrialLine {
    double force = 0;  ///< [N], 0 for the first line
    double slope = 1;  ///< [N/m], > 0
};

/// Law of bit and rock as a fit varies it (T4) (T5) (T40). The last line has no end.
struct TrialRock {
    std::vector<TrialLine> lines = {{}};  ///< loading, forces increasing
    double elastic = 1;                   ///< k/γ below the largest force so far [N/m]
    double gap = 0;                       ///< d ≥ 0 [m]
    double dashpot = 0;                   ///< c ≥ 0 beside the spring, in contact [N s/m]
};

/// Secant-preserving straight lines of F = kU (U/U1)^(p − 1), where the secant at `reference` [N] is k.
std::vector<TrialLine> powerLines(double stiffness, double exponent, double reference);

/// Bit on the rock at the end of a section of impedance Z: U' = (2g − F)/Z (T16), on a specimen before a bar
/// of the same impedance U' = (2g − 2F)/Z; with a bit mass M U'' + Z U' + F = 2g. Within a step g is linear,
/// and each line of the law is followed exactly; corners of the law are found within the step. With a bit
/// mass the step is that of the trapezoidal rule.
class RockResponse {
  public:
    struct End {
        double impedance = 1;  ///< Z of the last section [N s/m]
        double mass = 0;       ///< M [kg]
        bool barBehind = false;
    };
    RockResponse(const TrialRock& rock, const End& end, double step);

    /// Goes over one step in which g changes from `g0` to `g1` [N].
    void advance(double g0, double g1);

    double force() const { return m_force; }  ///< F ≥ 0 [N] at the end of the step
    /// The wave b that leaves the rock where g arrives [N].
    double reflected(double g) const { return m_mass > 0 ? g - m_impedance * m_velocity : m_force - g; }
    double penetration() const;  ///< of the bit from the untouched rock, negative across the gap [m]
    bool hasUnloaded(double share) const { return m_spring < (1 - share) * m_largest; }

  private:
    enum class Line { apart, primary, elastic };
    struct Wave {
        double g, rate;  ///< 2g/β and its change per s
    };
    double rateOf(double slope) const { return slope / (m_impedance + m_dashpot); }
    double springAfter(const Wave& wave, double rate, double time) const;
    double timeTo(const Wave& wave, double rate, double end, double force) const;
    bool follow(Wave& wave, double& left);
    void load(const Wave& wave, double& left);
    void unload(const Wave& wave, double& left);
    void fly(const Wave& wave, double& left);
    void advanceMass(double g0, double g1);
    void touch();
    void separate();
    double largestPenetration() const;

    const TrialRock& m_rock;
    double m_impedance;  ///< Z, half of it before a bar
    double m_double;     ///< 2 over the number of bars
    double m_mass;
    double m_dashpot;
    double m_step;
    Line m_line = Line::apart;
    std::size_t m_loading = 0;       ///< line of the loading curve
    double m_loadedPenetration = 0;  ///< where that line begins [m]
    double m_spring = 0;             ///< force without the dashpot
    double m_largest = 0;            ///< Fm
    double m_place = 0;              ///< of the bit while apart [m]
    double m_contact = 0;            ///< place of the rock's surface [m]
    double m_velocity = 0;           ///< of the mass
    double m_force = 0;
};

}  // namespace drillwave
