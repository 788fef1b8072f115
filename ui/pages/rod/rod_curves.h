// SPDX-License-Identifier: GPL-3.0-or-later
// The largest stresses along rod or drill string as ready plot data, built away from the window's thread.
#pragma once

#include <QByteArray>
#include <array>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/blow/blow.h"
#include "core/model/scenario.h"
#include "core/wave/field/rod_envelope.h"
#include "ui/pages/rod/string_rod.h"
#include "ui/plot/graph_data.h"
#include "ui/runs/run_overlay.h"
#include "ui/text/shown_units.h"

namespace drillwave {

/// Never changed once built; shown stresses are positive in tension.
struct RodCurves {
    ShownUnits units;
    RodEnvelope envelope;                        ///< dimensionless
    std::array<GraphData, loads.size()> curves;  ///< position in the rod, stress
    std::optional<double> yieldStrength, fatigueStrength;
    double strengthFactor = 0;                     ///< from Pa to stresses as shown
    std::optional<StringRod> string = {};          ///< of a drill string, which has strengths of its own
    std::vector<RunOverlay<RodCurves>> runs = {};  ///< laid over them

    const GraphData& curve(Load line) const { return curves[static_cast<std::size_t>(line)]; }
    const EnvelopeLine& forces(Load line) const { return envelope[line]; }
    /// The lines that are there: a string may not be followed beyond the blow.
    std::span<const Load> lines() const {
        const bool hasAfter = !string || !envelope.tensionAfter.empty();
        return std::span(loads).first(hasAfter ? loads.size() : 2);
    }
    /// The largest at a place, in lengths of rod or string.
    RodForce forceAt(Load line, double section) const;
    /// Where rod or string begins, in the same lengths.
    double rear() const { return string ? string->rear() : 0; }
    const RodForce& largest(Load line) const { return envelope.largest[line]; }
    /// Returns the stress as shown.
    double stress(Load line, const RodForce& force) const {
        return (isTension(line) ? 1 : -1) * force.size * units.stress.factor;
    }
    /// Returns the shown strength of a section of a string; `strength` in Pa.
    std::optional<double> shownStrength(const std::optional<double>& strength) const {
        return strength ? std::optional(*strength * strengthFactor) : std::nullopt;
    }
    double position(const RodForce& force) const { return force.section * units.length.factor; }
};

/// Returns no lines for strings whose waves were not kept; requires the histories of rods. A stop ends the
/// work early, with lines that are too low.
RodCurves rodCurves(const Blow& blow, const ShownUnits& units, const std::stop_token& stop = {});

/// Returns position, stress and time of each line, side by side, in the units shown.
QByteArray rodCsv(const RodCurves& curves, char separator);

}  // namespace drillwave
