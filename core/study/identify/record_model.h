// SPDX-License-Identifier: GPL-3.0-or-later
// Record expected for trial values of all unknowns, and its residuals.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/study/identify/gauge_pair.h"
#include "core/study/identify/prepared_record.h"

namespace drillwave {

/// Loading curve that is fitted.
/// `crater`: the bit stands in rock that an earlier force has loaded, and reloads it first.
enum class TrialLaw { bilinear, corner, power, dashpot, crater, held };

/// One unknown of a fit. A prior is normal; without a deviation there is none.
struct Unknown {
    enum class Kind {
        stiffness,         ///< ln k
        gamma,             ///< ln γ
        gap,               ///< d [m]
        lag,               ///< of b against D0 [s]
        cornerForce,       ///< ln F_1
        cornerSlope,       ///< ln s_1
        exponent,          ///< p of a power law
        dashpot,           ///< ln c
        memory,            ///< largest force before the blow [N]
        impedance,         ///< z of the gauge's section, relative
        length,            ///< of a section towards the bit, added [m]
        sectionImpedance,  ///< of a section towards the bit, relative
        shape,             ///< share of a LinearShape in the record
    };
    Kind kind = Kind::stiffness;
    std::size_t index = 0;  ///< of section or shape
    double step = 1e-3;     ///< of differences
    double low = 0, high = 0;
    double mean = 0, deviation = 0;
    bool isHeld = false;
};

using UnknownKind = Unknown::Kind;

/// A 95 % tolerance over its deviation.
inline constexpr double half95 = 1.96;

/// A signal that the record holds in an unknown amount: zero lines ("offset.1", "slope.1"), droop, curvature
/// of the gain, gain of the returning wave, bending left in a pair ("bending.1"), a jump of the zero,
/// dispersion about a share of it.
struct LinearShape {
    std::string key;  ///< "offset.1", "droop", "gain", …
    double mean = 0, deviation = 0, low = 0, high = 0;
    double tolerance = 0;           ///< 95 % of the prior
    std::vector<double> incident;   ///< on the grid of the model [N for 1]
    std::vector<double> returning;  ///< at the samples of b
    std::vector<double> quiet;      ///< at those of the quiet stretch
};

/// Tolerances of the section sizes towards the bit and of Z of the gauge's section, 95 %.
struct SizeTolerances {
    double impedance = 0;            ///< relative, of the gauge's section
    std::vector<double> lengths;     ///< [m] of each section towards the bit
    std::vector<double> impedances;  ///< relative
};

/// Residuals of one prepared record under one law. Not copied while in use: it keeps workspace.
class RecordModel {
  public:
    RecordModel(const PreparedRecord& record, const IdentifyQuestion& question, const SizeTolerances& sizes,
                TrialLaw law);

    const std::vector<Unknown>& unknowns() const { return m_unknowns; }
    std::vector<Unknown>& unknowns() { return m_unknowns; }
    const std::vector<LinearShape>& shapes() const { return m_shapes; }
    const PreparedRecord& record() const { return *m_record; }
    TrialLaw law() const { return m_law; }

    /// Takes the dispersion about this share κ; as an unknown, its amount is κ.
    void setDispersion(double share, bool isFree);
    bool hasDispersion() const { return m_hasDispersion; }
    DispersionChoice dispersionChoice() const { return m_dispersion; }
    /// A zero that jumps by 1 of the peak at `time`; replaces the jump that is there.
    void setJump(double time, double tolerance);
    void removeJump();
    /// Holds or frees section sizes.
    void holdSizes(bool isHeld);
    /// Deviations of the tail in the quiet stretch [N], before its last 120 µs and in them.
    void setQuietErrors(double before, double last);

    /// Residuals for values of the unknowns: of b, of the quiet stretch, of the priors.
    void residuals(const Eigen::VectorXd& values, Eigen::VectorXd& result);
    /// Residuals of b and of the stretch for changes of the signals of the gauges by `change` [N].
    void changedResiduals(const Eigen::VectorXd& values, const SeparatedWaves& change,
                          const std::vector<double>& quietChange, Eigen::VectorXd& result);

    std::size_t returningCount() const { return m_returning.size(); }
    std::size_t quietCount() const { return m_quiet.size(); }
    std::size_t firstReturning() const { return m_firstReturning; }  ///< sample of the record
    std::size_t firstQuiet() const { return m_firstQuiet; }
    std::size_t priorRow(std::size_t unknown) const;  ///< row of its prior
    std::size_t rows() const { return m_rows; }
    double weight() const { return m_weight; }  ///< of b, away from fronts [1/N]
    /// Share of that weight which a sample of b has; less where a front passes within a sample.
    double returningShare(std::size_t i) const { return m_shares[i]; }
    double quietWeight(std::size_t i) const { return m_quietWeights[i]; }
    const std::vector<double>& quietSignal() const { return m_quiet; }
    std::size_t find(Unknown::Kind kind, std::size_t index = 0) const;  ///< size() where there is none
    std::size_t findShape(const std::string& key) const;                ///< count where there is none
    std::size_t shapeUnknown(const std::string& key) const;             ///< count where there is none

    TrialRock rockOf(const Eigen::VectorXd& values) const;
    /// Runs the model for these values, keeping force and penetration; b at the samples of the window [N].
    const ChainModel& solved(const Eigen::VectorXd& values);
    const std::vector<double>& modelReturning() const { return m_model; }  ///< of the last run [N]
    const std::vector<double>& incidentNow() const { return m_now; }       ///< f of the last run [N]
    double gridStep() const { return m_gridStep; }
    double gridStart() const { return m_gridStart; }
    /// f on the grid of the model.
    std::vector<double> onGrid(const std::vector<double>& incident) const;

  private:
    void addUnknowns(const IdentifyQuestion& question, const SizeTolerances& sizes);
    void addShapes(const IdentifyQuestion& question);
    void addShape(LinearShape shape, const std::vector<const std::vector<double>*>& ofGauges);
    void setShapeUnknown(std::size_t shape);
    void runModel(const Eigen::VectorXd& values, bool keepsRock);
    void setRows();
    void setShares();
    void addToRecord(const SeparatedWaves& change, const std::vector<double>& quietChange);
    RockEnd endOf(const Eigen::VectorXd& values) const;

    const PreparedRecord* m_record;
    TrialLaw m_law;
    TrialRock m_heldRock;
    std::vector<Unknown> m_unknowns;
    std::vector<LinearShape> m_shapes;
    SeparatedWaves m_waves;  ///< of the record as prepared, plane waves
    bool m_hasDispersion = false;
    DispersionChoice m_dispersion;
    std::vector<double> m_incident;  ///< f on the grid
    std::vector<double> m_returning, m_quiet, m_quietWeights;
    std::vector<double> m_shares;  ///< of the weight, for each sample of b
    std::size_t m_firstReturning = 0, m_firstQuiet = 0;
    double m_gridStep = 0, m_gridStart = 0;
    std::size_t m_gridCount = 0;
    double m_weight = 1;
    double m_attenuated = 1;  ///< share of an amplitude left between gauge and end of its section
    std::size_t m_rows = 0;
    ChainModel m_chain;
    std::vector<double> m_now, m_model, m_left;
};

}  // namespace drillwave
