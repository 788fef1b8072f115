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

/// Rock law that a fit tries. With `crater`, the bit stands in rock that an earlier force has loaded, and
/// first reloads it. With `held`, the law of the scenario file is used unchanged.
enum class TrialLaw { bilinear, corner, power, dashpot, crater, held };

/// Unknown of a fit: a rock parameter, the size of a section, or the amount of a disturbance (such as a
/// shifted zero line). Its prior is normal, with `mean` and `deviation`. A `deviation` of 0 means no prior.
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

/// Half-width of the central 95 % of a normal distribution, in standard deviations. It converts 95 %
/// tolerances to standard deviations.
inline constexpr double half95 = 1.96;

/// Lower limit for the assumed rms of stray waves between blow and reflection, as a share of the peak force.
inline constexpr double quietFloor = 0.003;

/// Disturbance of the record with a known shape over time and an unknown amount. Examples are zero lines
/// ("offset.1", "slope.1"), droop of the amplifier, and a different gain of the returning wave. Others are
/// bending that remains in the mean of a gauge pair ("bending.1"), a jump of the zero level, and dispersion.
struct LinearShape {
    std::string key;  ///< name of the disturbance: "offset.1", "droop", "gain", …
    double mean = 0, deviation = 0, low = 0, high = 0;
    double tolerance = 0;  ///< 95 % tolerance of the amount according to the prior
    /// Part of the incident wave that the disturbance with amount 1 causes, at the time steps of the model
    /// [N].
    std::vector<double> incident;
    /// Part of the returning wave b that the disturbance with amount 1 causes, one value per sample [N].
    std::vector<double> returning;
    /// Part of the samples between blow and reflection that the disturbance with amount 1 causes [N].
    std::vector<double> quiet;
};

/// 95 % tolerances of section sizes for the fit: of the section with the gauge, and of the sections from
/// there to the bit.
struct SizeTolerances {
    double impedance = 0;         ///< relative tolerance of the impedance Z of the gauge's section
    std::vector<double> lengths;  ///< tolerance of the length of each section towards the bit [m]
    /// Relative tolerance of the impedance of each section between the section with the gauge and the rock.
    std::vector<double> impedances;
};

/// Least-squares model of one prepared record with one rock law: computes the residuals for trial values of
/// the unknowns. Contains buffers, so each thread needs its own object.
class RecordModel {
  public:
    RecordModel(const PreparedRecord& record, const IdentifyQuestion& question, const SizeTolerances& sizes,
                TrialLaw law);

    const std::vector<Unknown>& unknowns() const { return m_unknowns; }
    std::vector<Unknown>& unknowns() { return m_unknowns; }
    const std::vector<LinearShape>& shapes() const { return m_shapes; }
    const PreparedRecord& record() const { return *m_record; }
    TrialLaw law() const { return m_law; }

    /// Applies the share κ of a round bar's dispersion to the waves of the record: 0 none, 1 full. If
    /// `isFree`, κ becomes an unknown of the fit, and the model is linearised about `share`.
    void setDispersion(double share, bool isFree);
    bool hasDispersion() const { return m_hasDispersion; }
    DispersionChoice dispersionChoice() const { return m_dispersion; }
    /// Returns the share κ of dispersion that applies if κ is not fitted: 1 for DispersionChoice::bar,
    /// otherwise 0.
    double heldShare() const { return m_dispersion == DispersionChoice::bar ? 1 : 0; }
    /// Returns the share κ of a round bar's dispersion for these values of the unknowns: 0 none, 1 full.
    double dispersionShare(const Eigen::VectorXd& values) const;
    /// Returns a wave, sampled at the time steps of the model, with the dispersion of `way` [m] in a bar like
    /// that of the gauge. The travel time itself is not added. `values` contain the share of dispersion.
    std::vector<double> dispersed(const std::vector<double>& wave, double way,
                                  const Eigen::VectorXd& values) const;
    /// Adds a jump of the zero level at `time` after the front [s] as a disturbance; replaces an earlier one.
    /// `tolerance` is the 95 % tolerance of its height, as a share of the peak force.
    void setJump(double time, double tolerance);
    void removeJump();
    /// Holds all section sizes at their given values (true), or makes them unknowns of the fit (false).
    void holdSizes(bool isHeld);
    /// Sets the weights of the samples between the end of the blow and its reflection. `before` and `last`
    /// are the rms of stray waves there [N]: `last` in the last 120 µs, `before` earlier.
    void setQuietErrors(double before, double last);

    /// Computes the weighted residuals for values of the unknowns and writes them to `result`. First are the
    /// samples of the returning wave b, then the samples between blow and reflection, then the priors.
    void residuals(const Eigen::VectorXd& values, Eigen::VectorXd& result);
    /// Computes the weighted residuals for a changed record, to find how errors of the record affect the fit.
    /// `change` [N] is added to its waves, and `quietChange` [N] to its samples between blow and reflection.
    void changedResiduals(const Eigen::VectorXd& values, const SeparatedWaves& change,
                          const std::vector<double>& quietChange, Eigen::VectorXd& result);

    std::size_t returningCount() const { return m_returning.size(); }
    std::size_t quietCount() const { return m_quiet.size(); }
    /// Returns the index, in the record, of the first sample of the returning wave that the fit compares with
    /// the model.
    std::size_t firstReturning() const { return m_firstReturning; }
    std::size_t firstQuiet() const { return m_firstQuiet; }
    /// Returns the index, in the vector of residuals, of the residual that the prior of an unknown
    /// contributes.
    std::size_t priorRow(std::size_t unknown) const;
    std::size_t rows() const { return m_rows; }
    /// Returns the weight of the residuals of the returning wave [1/N]. Near a wave front, returningShare()
    /// reduces it.
    double weight() const { return m_weight; }
    /// Returns the factor, 0 … 1, on the weight of sample i of the returning wave. It is below 1 near a steep
    /// wave front, whose time is only known to within one sample.
    double returningShare(std::size_t i) const { return m_shares[i]; }
    double quietWeight(std::size_t i) const { return m_quietWeights[i]; }
    const std::vector<double>& quietSignal() const { return m_quiet; }
    /// Returns the index, in unknowns(), of the unknown of this kind and index; the number of unknowns if
    /// there is none.
    std::size_t find(Unknown::Kind kind, std::size_t index = 0) const;
    /// Returns the index, in shapes(), of the disturbance with this key, such as "droop"; the number of
    /// disturbances if there is none.
    std::size_t findShape(const std::string& key) const;
    /// Returns the index, in unknowns(), of the amount of the disturbance with this key, such as "droop"; the
    /// number of unknowns if there is none.
    std::size_t shapeUnknown(const std::string& key) const;

    TrialRock rockOf(const Eigen::VectorXd& values) const;
    /// Runs the wave model for values of the unknowns and returns it with the force on the rock and the
    /// penetration. Afterwards modelReturning() has the returning wave b.
    const ChainModel& solved(const Eigen::VectorXd& values);
    /// Returns the returning wave b of the last run of the model, at the samples that the fit compares [N].
    const std::vector<double>& modelReturning() const { return m_model; }
    /// Returns the incident wave f of the last run of the model at its time steps [N]. Fitted disturbances
    /// are subtracted, and the attenuation up to the end of the gauge's section is included.
    const std::vector<double>& incidentNow() const { return m_now; }
    double gridStep() const { return m_gridStep; }
    double gridStart() const { return m_gridStart; }
    /// Returns an incident wave f [N] at the time steps of the model, interpolated from the samples of the
    /// record.
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
    /// Share of a wave amplitude that is left after the way from the gauge to the end of its section, 0 … 1.
    double m_attenuated = 1;
    std::size_t m_rows = 0;
    ChainModel m_chain;
    std::vector<double> m_now, m_model, m_left;
};

}  // namespace drillwave
