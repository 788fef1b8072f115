// SPDX-License-Identifier: GPL-3.0-or-later
// Model of a record for trial values of all unknowns, and its residuals.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/study/identify/gauge_pair.h"
#include "core/study/identify/prepared_record.h"

namespace drillwave {

/// Loading curve of a fit. With `crater`, the bit stands in rock that an earlier force has loaded, and first
/// reloads it. With `held`, the law of the scenario file is used unchanged.
enum class TrialLaw { bilinear, corner, power, dashpot, crater, held };

/// Unknown of a fit: a rock parameter, a size or the amount of a disturbance. Its prior is normal; without a
/// standard deviation there is no prior.
struct Unknown {
    enum class Kind {
        stiffness,         ///< ln k, logarithm of the stiffness [N/m]
        gamma,             ///< ln γ, logarithm of the elasticity
        gap,               ///< gap d between bit and rock [m]
        lag,               ///< delay of the returning wave b relative to the round-trip time D0 [s]
        cornerForce,       ///< ln F1, logarithm of the force at the corner [N]
        cornerSlope,       ///< ln s1, logarithm of the slope after the corner relative to k
        exponent,          ///< exponent p of a power law
        dashpot,           ///< ln c, logarithm of the dashpot constant [N s/m]
        memory,            ///< largest force on the rock before this blow [N]
        impedance,         ///< relative change of the impedance of the gauge's section
        length,            ///< increase of the length of a section between gauge and rock [m]
        sectionImpedance,  ///< relative change of the impedance of a section between gauge and rock
        shape,             ///< amount of a LinearShape (a disturbance) in the record
    };
    Kind kind = Kind::stiffness;
    std::size_t index = 0;  ///< index of the section or shape that the unknown belongs to
    double step = 1e-3;     ///< step for numerical derivatives, in the unit of the unknown
    double low = 0, high = 0;
    double mean = 0, deviation = 0;
    bool isHeld = false;
};

using UnknownKind = Unknown::Kind;

/// Ratio of a 95 % tolerance to the standard deviation of a normal distribution.
inline constexpr double half95 = 1.96;

/// Smallest rms of waves between blow and reflection that is assumed, relative to the peak force.
inline constexpr double quietFloor = 0.003;

/// Disturbance of known shape and unknown amount in the record. Examples are zero lines ("offset.1",
/// "slope.1"), droop, curvature of the gain and a different gain of the returning wave. Others are bending
/// left in a pair ("bending.1"), a jump of the zero level, and dispersion.
struct LinearShape {
    std::string key;  ///< name of the disturbance: "offset.1", "droop", "gain", …
    double mean = 0, deviation = 0, low = 0, high = 0;
    double tolerance = 0;  ///< 95 % tolerance of the amount according to the prior
    /// Contribution to the incident wave at the times of the model, for amount 1 [N].
    std::vector<double> incident;
    /// Contribution to the samples of the returning wave b, for amount 1 [N].
    std::vector<double> returning;
    /// Contribution to the samples between blow and reflection (the quiet stretch), for amount 1 [N].
    std::vector<double> quiet;
};

/// 95 % tolerances of the impedance of the gauge's section and of the sizes of the sections towards the bit.
struct SizeTolerances {
    double impedance = 0;         ///< relative tolerance of the impedance Z of the gauge's section
    std::vector<double> lengths;  ///< tolerance of the length of each section towards the bit [m]
    /// Relative tolerance of the impedance of each section towards the bit.
    std::vector<double> impedances;
};

/// Residuals of one prepared record for one rock law. Contains buffers, so each thread needs its own object.
class RecordModel {
  public:
    RecordModel(const PreparedRecord& record, const IdentifyQuestion& question, const SizeTolerances& sizes,
                TrialLaw law);

    const std::vector<Unknown>& unknowns() const { return m_unknowns; }
    std::vector<Unknown>& unknowns() { return m_unknowns; }
    const std::vector<LinearShape>& shapes() const { return m_shapes; }
    const PreparedRecord& record() const { return *m_record; }
    TrialLaw law() const { return m_law; }

    /// Applies a share κ of the dispersion of a round bar, 0 … 1. If `isFree`, κ becomes an unknown and the
    /// model is linearised about this share.
    void setDispersion(double share, bool isFree);
    bool hasDispersion() const { return m_hasDispersion; }
    DispersionChoice dispersionChoice() const { return m_dispersion; }
    /// Returns the share κ of dispersion that holds if κ is no unknown: 1 for a round bar, else 0.
    double heldShare() const { return m_dispersion == DispersionChoice::bar ? 1 : 0; }
    /// Returns the share κ of dispersion for values of the unknowns.
    double dispersionShare(const Eigen::VectorXd& values) const;
    /// Returns a wave at the times of the model after it has travelled the distance `way` [m] in a bar like
    /// that of the gauge, with the share of dispersion that these values have.
    std::vector<double> dispersed(const std::vector<double>& wave, double way,
                                  const Eigen::VectorXd& values) const;
    /// Adds a disturbance: a jump of the zero level at `time` after the front [s], with the peak force as
    /// unit. `tolerance` is its 95 % tolerance in this unit. Replaces an earlier jump.
    void setJump(double time, double tolerance);
    void removeJump();
    /// Holds the section sizes at their given values, or frees them for the fit.
    void holdSizes(bool isHeld);
    /// Sets the weights of the samples between blow and reflection (the quiet stretch). `before` and `last`
    /// are the rms of waves there [N], before the last 120 µs and within them.
    void setQuietErrors(double before, double last);

    /// Computes the weighted residuals for values of the unknowns and writes them to `result`. First come
    /// those of the returning wave b, then those of the samples between blow and reflection, then those of
    /// the priors.
    void residuals(const Eigen::VectorXd& values, Eigen::VectorXd& result);
    /// Computes the weighted residuals for a changed record: its waves are changed by `change` [N], its
    /// samples between blow and reflection by `quietChange` [N].
    void changedResiduals(const Eigen::VectorXd& values, const SeparatedWaves& change,
                          const std::vector<double>& quietChange, Eigen::VectorXd& result);

    std::size_t returningCount() const { return m_returning.size(); }
    std::size_t quietCount() const { return m_quiet.size(); }
    /// Returns the index in the record of the first sample of the returning wave that is compared with the
    /// model.
    std::size_t firstReturning() const { return m_firstReturning; }
    std::size_t firstQuiet() const { return m_firstQuiet; }
    /// Returns the row of the residuals that holds the prior of an unknown.
    std::size_t priorRow(std::size_t unknown) const;
    std::size_t rows() const { return m_rows; }
    /// Returns the weight of a sample of the returning wave away from fronts [1/N].
    double weight() const { return m_weight; }
    /// Returns the factor, 0 … 1, by which the weight of sample i of the returning wave is reduced. It is
    /// below 1 where a front passes within a sample.
    double returningShare(std::size_t i) const { return m_shares[i]; }
    double quietWeight(std::size_t i) const { return m_quietWeights[i]; }
    const std::vector<double>& quietSignal() const { return m_quiet; }
    /// Returns the index of an unknown; the number of unknowns if there is none.
    std::size_t find(Unknown::Kind kind, std::size_t index = 0) const;
    /// Returns the index of a disturbance; the number of disturbances if there is none.
    std::size_t findShape(const std::string& key) const;
    /// Returns the index of the unknown that is the amount of a disturbance; the number of unknowns if there
    /// is none.
    std::size_t shapeUnknown(const std::string& key) const;

    TrialRock rockOf(const Eigen::VectorXd& values) const;
    /// Runs the model for values of the unknowns and returns it, with force and penetration of the rock.
    /// Afterwards modelReturning() has b at the samples of the window [N].
    const ChainModel& solved(const Eigen::VectorXd& values);
    /// Returns the returning wave b of the last run at the samples of the window [N].
    const std::vector<double>& modelReturning() const { return m_model; }
    /// Returns the incident wave f of the last run at the times of the model [N], without disturbances.
    const std::vector<double>& incidentNow() const { return m_now; }
    double gridStep() const { return m_gridStep; }
    double gridStart() const { return m_gridStart; }
    /// Returns an incident wave f [N] interpolated from the samples of the record to the times of the model.
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
    SeparatedWaves m_waves;  ///< waves of the record as prepared, without dispersion
    bool m_hasDispersion = false;
    DispersionChoice m_dispersion;
    std::vector<double> m_incident;  ///< incident wave f at the times of the model [N]
    std::vector<double> m_returning, m_quiet, m_quietWeights;
    std::vector<double> m_shares;  ///< factor of the weight for each sample of the returning wave, 0 … 1
    std::size_t m_firstReturning = 0, m_firstQuiet = 0;
    double m_gridStep = 0, m_gridStart = 0;
    std::size_t m_gridCount = 0;
    double m_weight = 1;
    /// Share of a wave amplitude left between the gauge and the end of its section, 0 … 1.
    double m_attenuated = 1;
    std::size_t m_rows = 0;
    ChainModel m_chain;
    std::vector<double> m_now, m_model, m_left;
};

}  // namespace drillwave
