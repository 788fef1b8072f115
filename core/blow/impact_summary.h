// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of files §4 for one solved blow, dimensionless and in SI, with their names.
#pragma once

#include <span>
#include <string_view>

#include "core/model/scales.h"
#include "core/model/scenario.h"
#include "core/text/units.h"
#include "core/wave/impact.h"

namespace drillwave {

/// The energy ledger: where the work of the hammer went, as fractions of W; together 1 + residual.
struct EnergyLedger {
    double rockWork = 0;
    double reboundEnergy = 0;
    double residualWaveEnergy = 0;
    double residual = 0;
};

/// Everything of files §4, dimensionless.
struct ImpactSummary {
    double cor = 0;
    double impulse = 0;
    double peakForce = 0;            ///< F0
    double maxPenetration = 0;       ///< d0
    double residualPenetration = 0;  ///< d0
    double firstContactTime = 0;     ///< t0
    double separationTime = 0;       ///< t0
    double contactDuration = 0;      ///< t0
    double workRatio = 0;            ///< W/W0 [paper (2)]
    EnergyLedger energy;
    double momentumResidual = 0;  ///< of I0
    double corError = 0;
    double growth = 1;  ///< Impact::growth
    int contacts = 0;   ///< separate contacts
};

/// Of an impact solved with Detail::summary or more. From one solved with Detail::cor only `cor`, `impulse`
/// and `corError` mean anything.
ImpactSummary summarize(const Impact& impact, const Groups& groups);

/// One named output: JSON key, CSV column and --outputs name.
struct Output {
    std::string_view name;                  ///< "peak_force"
    std::string_view meaning;               ///< one line
    Quantity quantity;                      ///< `ratio` where SI is the same number
    Detail detail;                          ///< what the solver must be asked for
    double (*value)(const ImpactSummary&);  ///< dimensionless
    double (*scale)(const Scales&);         ///< SI = value · scale
};

/// All outputs in the order of files §4, without `thrust`.
std::span<const Output> outputs();

/// The output of that name, or nullptr.
const Output* findOutput(std::string_view name);

}  // namespace drillwave
