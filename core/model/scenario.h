// SPDX-License-Identifier: GPL-3.0-or-later
// Drilling scenario as plain values. It describes the problem, not how it is solved.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/model/drill_string.h"

namespace drillwave {

// Points of a tabulated hammer force. The list never changes, so that copies of a scenario share it.

/// Point of a tabulated hammer force: time [s] and force [N], or any units in a dimensionless scenario.
struct TablePoint {
    double time = 0;
    double force = 0;
    bool operator==(const TablePoint&) const = default;
};

/// Immutable list of points with value semantics. Copies share the memory, so that copying a long list is
/// cheap.
class TablePoints {
  public:
    TablePoints() = default;
    TablePoints(std::vector<TablePoint> points)
        : m_points(points.empty() ? nullptr
                                  : std::make_shared<const std::vector<TablePoint>>(std::move(points))) {}
    TablePoints(std::initializer_list<TablePoint> points) : TablePoints(std::vector<TablePoint>(points)) {}

    bool empty() const { return !m_points; }
    std::size_t size() const { return list().size(); }
    const TablePoint& operator[](std::size_t i) const { return list()[i]; }
    const TablePoint& front() const { return list().front(); }
    const TablePoint& back() const { return list().back(); }
    auto begin() const { return list().begin(); }
    auto end() const { return list().end(); }

    /// Returns whether two lists share memory. Lists with equal points may still have separate memory.
    bool isSharedWith(const TablePoints& other) const { return m_points == other.m_points; }

    friend bool operator==(const TablePoints& a, const TablePoints& b) {
        return a.isSharedWith(b) || a.list() == b.list();
    }

  private:
    const std::vector<TablePoint>& list() const {
        static const std::vector<TablePoint> none;
        return m_points ? *m_points : none;
    }

    std::shared_ptr<const std::vector<TablePoint>> m_points;  // nullptr if there are no points
};

/// Shape over time of the force of the hammer on the rear end of the rod or drill string (files §1.1).
enum class PulseShape {
    rectangular,  ///< constant over the duration t0
    triangular,   ///< symmetric linear rise and fall within t0
    halfSine,     ///< one half period of a sine within t0
    trapezoid,    ///< linear rise, plateau and linear fall within t0
    exponential,  ///< rigid hammer: force ∝ exp(−t/t0), without an end
    /// Uniform elastic hammer: the force falls in steps of the duration t0. The impedances of hammer and rod
    /// determine the heights of the steps.
    piston,
    table,  ///< given points, with linear interpolation between them
    /// Reference case without a hammer force: the rod arrives with uniform velocity and no waves.
    rigidBody,
};

/// Returns the name of a shape as in scenario files, such as "half_sine".
std::string_view name(PulseShape shape);
std::optional<PulseShape> findPulseShape(std::string_view name);
/// Returns the names of all shapes for menus and messages, in the order of PulseShape.
std::span<const std::string_view> pulseShapeNames();

/// Uniform elastic rod. All values in SI.
struct Rod {
    double length = 3.66;          ///< length L [m]
    double diameter = 0.038;       ///< outer diameter [m]; unused if `area` is given
    double bore = 0;               ///< diameter of the flushing hole [m]; unused if `area` is given
    std::optional<double> area;    ///< cross-section A [m²]; if given, replaces diameter and bore
    double youngsModulus = 210e9;  ///< Young's modulus E [Pa]
    double density = 7850;         ///< density ρ [kg/m³]
    /// Yield strength [Pa]; a higher stress raises a warning but changes no result.
    std::optional<double> yieldStrength;
    /// Fatigue strength [Pa] for many blows; a higher tensile stress raises a warning.
    std::optional<double> fatigueStrength;
    bool operator==(const Rod&) const = default;
};

/// Uniform elastic hammer that strikes the rod if the shape of the force is `piston`, in SI units. A
/// dimensionless scenario uses only `impedanceRatio`.
struct Piston {
    double length = 0.5;                  ///< length of the hammer [m]
    double diameter = 0.038;              ///< diameter of the hammer [m]
    double velocity = 10;                 ///< impact velocity [m/s]
    std::optional<double> youngsModulus;  ///< Young's modulus [Pa] (default: that of the rod)
    std::optional<double> density;        ///< density [kg/m³] (default: that of the rod)
    /// Impedance of the hammer divided by that of the rod, q > 0; only for dimensionless scenarios.
    double impedanceRatio = 1;
    bool operator==(const Piston&) const = default;
};

/// Force of the hammer on the rear end over time. Shapes `piston` and `table` determine duration and impulse
/// themselves.
struct Pulse {
    PulseShape shape = PulseShape::rectangular;
    /// Duration t0 of the force [s]; for `exponential` its time constant. Not used for `piston` and `table`.
    double duration = 200e-6;
    double impulse = 51;            ///< impulse I0 of the force [N s]; not used for `piston` and `table`
    bool impulseFromForce = false;  ///< whether the user gave the mean force I0/t0; files then keep the force
    double rise = 0.2;              ///< rise time of `trapezoid` as a share of the duration
    double fall = 0.3;              ///< fall time of `trapezoid` as a share of the duration
    Piston piston;
    /// Path of the file with the points of `table`, as written in the scenario; empty if the scenario
    /// contains the points.
    std::string tableFile;
    TablePoints tablePoints;  ///< points of `table`, with strictly increasing times and forces ≥ 0
    bool operator==(const Pulse&) const = default;
};

/// Form of the loading curve of the bit–rock law, force over penetration (files §1.4).
enum class RockLaw {
    bilinear,  ///< loading along one straight line of slope k
    corners,   ///< loading along several straight lines, which meet at corners
    power,     ///< power law F = kU (U/U1)^(p − 1), approximated by straight lines
};

/// Returns the name of a rock law as in scenario files, such as "bilinear".
std::string_view name(RockLaw law);
/// Returns the words for a rock law in messages, such as "a power law".
std::string_view phrase(RockLaw law);
std::optional<RockLaw> findRockLaw(std::string_view name);
/// Returns the names of all rock laws, in the order of RockLaw.
std::span<const std::string_view> rockLawNames();

/// Corner of the loading curve, where its slope changes. NaN means not given yet.
struct RockCorner {
    /// Force at the corner [N]; in a dimensionless scenario in units of F0.
    double force = std::numeric_limits<double>::quiet_NaN();
    /// Slope of the loading curve above this corner as a multiple of the stiffness k, > 0.
    double slope = std::numeric_limits<double>::quiet_NaN();
    bool operator==(const RockCorner& other) const {
        const auto same = [](double a, double b) { return a == b || (a != a && b != b); };
        return same(force, other.force) && same(slope, other.slope);
    }
};

/// Bit–rock law, force over penetration. Loading follows the loading curve. Below the largest force so far,
/// unloading and reloading follow a straight line of slope k/γ.
struct BitRock {
    /// Stiffness k of loading [N/m]: slope of the first straight line of the loading curve. For the law
    /// `power` it is the slope of the secant from 0 to U1.
    double stiffness = 105e6;
    double gamma = 0.1;  ///< elasticity γ = loading/unloading stiffness, 0 < γ ≤ 1
    double gap = 0;      ///< initial gap d between bit and rock [m], ≥ 0
    RockLaw law = RockLaw::bilinear;
    std::vector<RockCorner> corners;  ///< corners of the law `corners`, with increasing forces
    double exponent = 1;              ///< exponent p of the law `power`, F ∝ U^p; 0.3 … 3
    /// Penetration U1 [m] of the law `power`, at which the force is k U1; in a dimensionless scenario in
    /// units of d0.
    double referencePenetration = 1e-3;
    bool operator==(const BitRock&) const = default;
};

/// State of the rock under the buttons of the bit at the next blow.
enum class RockIndexing {
    fresh,  ///< intact rock: the bit has turned since the last blow
    same,   ///< the crater that the last blow left
};

/// Returns the name of a state of the rock as in scenario files: "fresh" or "same".
std::string_view name(RockIndexing indexing);
std::optional<RockIndexing> findRockIndexing(std::string_view name);
/// Returns the names of the states that the rock may have at the next blow: "fresh" and "same".
std::span<const std::string_view> rockIndexingNames();

/// Operating data of the rock drill. All of them are optional.
struct Drill {
    std::optional<double> blowFrequency;  ///< blow frequency f [Hz]
    std::optional<double> thrust;         ///< installed feed force [N], key `drill.thrust`
    /// Mass of the rock drill without rod and string [kg]. The feed pushes it together with the rod.
    std::optional<double> machineMass;
    /// Angle of the hole below the horizontal [deg], −90 (upwards) … 90 (downwards).
    std::optional<double> inclination;
    // used only for simulations of many blows
    std::optional<double> damperDamping;    ///< dashpot c_d between machine and rear end of the rod [N s/m]
    std::optional<double> damperStiffness;  ///< spring k_d between machine and rear end of the rod [N/m]
    RockIndexing indexing = RockIndexing::fresh;
    std::optional<double> waveLoss;  ///< share η that waves lose per round trip in the rod, 0 ≤ η < 1
    std::optional<double> blows;     ///< number N of simulated blows, a whole number
    /// Number of transient blows, at the start of the simulation, that statistics exclude; a whole number.
    std::optional<double> settle;
    /// Standard deviation of the interval between blows (normal distribution), as a multiple of 1/f.
    std::optional<double> intervalScatter;
    std::optional<double> seed;  ///< seed of the random intervals, a whole number
    bool operator==(const Drill&) const = default;
};

/// The four dimensionless groups on which the solution depends (paper, section 5.1; T8).
struct Groups {
    double beta = 0.5;  ///< β = k/k0 > 0, stiffness of the rock relative to k0 = Z/t0
    double gamma = 1;   ///< elasticity γ = loading/unloading stiffness of the rock, 0 < γ ≤ 1
    double tau = 10;    ///< τ = T/t0 > 0, transit time of the rod relative to the duration of the blow
    double delta = 0;   ///< δ = d/d0 ≥ 0, gap relative to d0 = 2 I0/Z
    bool operator==(const Groups&) const = default;
};

/// Form of a scenario: uniform rod with or without units, or drill string.
enum class ScenarioForm {
    dimensional,    ///< uniform rod under a prescribed hammer force, in physical quantities
    dimensionless,  ///< uniform rod, given by its dimensionless groups
    /// Drill string of sections, struck by a hammer or a prescribed force, in physical quantities.
    string,
};

/// Contents of a scenario file. Members that the form of the scenario does not use keep their defaults.
struct Scenario {
    std::string title;
    ScenarioForm form = ScenarioForm::dimensional;
    Groups groups;  ///< groups of a dimensionless scenario; for other forms use groupsOf()
    Rod rod;        ///< uniform rod; used only by the form `dimensional`
    Pulse pulse;    ///< hammer force; used if isForced()
    /// Gap between bit and rock, and the bit–rock law. A dimensionless scenario uses only the shape of the
    /// loading curve.
    BitRock bitRock;
    Drill drill;              ///< operating data of the rock drill; not used by dimensionless scenarios
    DrillString drillString;  ///< hammer and string; used only by the form `string`
    bool operator==(const Scenario&) const = default;
};

/// Returns whether the scenario is in physical quantities, so that its results can be given in SI units.
inline bool hasUnits(const Scenario& scenario) {
    return scenario.form != ScenarioForm::dimensionless;
}
/// Returns whether the scenario is a drill string of sections, not a uniform rod.
inline bool isString(const Scenario& scenario) {
    return scenario.form == ScenarioForm::string;
}
/// Returns whether a prescribed force acts on the rod or string. If false, a hammer strikes it, and its
/// motion is simulated.
inline bool isForced(const Scenario& scenario) {
    return !isString(scenario) || scenario.drillString.hammer.sections.empty();
}

}  // namespace drillwave
