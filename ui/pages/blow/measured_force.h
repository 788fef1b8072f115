// SPDX-License-Identifier: GPL-3.0-or-later
// What the model says of a force that was measured.
#pragma once

#include <QString>
#include <functional>
#include <optional>

#include "core/blow/blow.h"
#include "core/signal/alignment.h"
#include "core/signal/measured_signal.h"
#include "ui/text/shown_units.h"

class QLocale;

namespace drillwave {

/// Force [N] over time [s] from 0 to `end`.
struct ComputedForce {
    std::function<double(double time)> at;
    double end;
};

/// x/L of a place that is x [m] from the struck end, in the rod or string, or in its hammer.
double shareAt(const Scenario& scenario, double x);

/// N in the section of the signal, or the impact force, up to `end` [s]. The blow has its histories, and its
/// scenario units; it is copied.
ComputedForce computedForce(const Blow& blow, const MeasuredSignal& signal, double end);

/// Nothing where they have no time in common.
std::optional<Misfit> misfitOf(const MeasuredSignal& signal, const ComputedForce& computed);

/// "rms 3.1 kN · peaks differ by −2 kN (−1.2 %) · lag 3 µs"
QString misfitText(const Misfit& misfit, const Scenario& scenario, const ShownUnits& units,
                   const QLocale& locale);

}  // namespace drillwave
