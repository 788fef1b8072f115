// SPDX-License-Identifier: GPL-3.0-or-later
// The largest stresses along rod or drill string as data of a plot, computed outside the window's thread.
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

/// Largest stresses along rod or drill string; never changed once built. Shown stresses are positive in
/// tension.
struct RodCurves {
    ShownUnits units;
    RodEnvelope envelope;                        ///< largest forces; dimensionless
    std::array<GraphData, loads.size()> curves;  ///< stress over position, for each load
    /// Strengths of a uniform rod, in the unit of the stresses shown.
    std::optional<double> yieldStrength, fatigueStrength;
    double strengthFactor = 0;  ///< factor from Pa to stresses as shown
    /// Sections of a drill string, which have their own strengths; empty for a uniform rod.
    std::optional<StringRod> string = {};
    std::vector<RunOverlay<RodCurves>> runs = {};  ///< curves of pinned runs (results kept for comparison)

    const GraphData& curve(Load line) const { return curves[static_cast<std::size_t>(line)]; }
    const EnvelopeLine& forces(Load line) const { return envelope[line]; }
    /// Returns the kinds of largest stress that have a curve: compression and tension in the blow, and those
    /// of the residual waves after it. A drill string that was not computed beyond the blow has only the
    /// first two.
    std::span<const Load> lines() const {
        const bool hasAfter = !string || !envelope.tensionAfter.empty();
        return std::span(loads).first(hasAfter ? loads.size() : 2);
    }
    /// Returns the largest force of the kind `line` at the position x/L = `section`. For a drill string its
    /// size is a stress, and L is the length of the string.
    RodForce forceAt(Load line, double section) const;
    /// Returns the position x/L of the rear end: 0 for a uniform rod; for a drill string that of its hammer,
    /// negative or 0.
    double rear() const { return string ? string->rear() : 0; }
    const RodForce& largest(Load line) const { return envelope.largest[line]; }
    /// Returns the stress of one of the largest forces, in the unit shown and positive in tension. `line`
    /// says whether `force` is a tension or a compression, because its size has no sign.
    double stress(Load line, const RodForce& force) const {
        return (isTension(line) ? 1 : -1) * force.size * units.stress.factor;
    }
    /// Converts a strength of a section from Pa to the unit of the stresses shown; empty if the strength is
    /// empty.
    std::optional<double> shownStrength(const std::optional<double>& strength) const {
        return strength ? std::optional(*strength * strengthFactor) : std::nullopt;
    }
    double position(const RodForce& force) const { return force.section * units.length.factor; }
};

/// Returns the largest stresses along rod or drill string in a blow. They are empty for drill strings whose
/// waves were not kept. A uniform rod requires time histories. A stop ends the work early; the stresses are
/// then too small.
RodCurves rodCurves(const Blow& blow, const ShownUnits& units, const std::stop_token& stop = {});

/// Returns a table with position, stress and time for each kind of largest stress, side by side, in the units
/// shown. `separator` stands between the cells.
QByteArray rodCsv(const RodCurves& curves, char separator);

}  // namespace drillwave
