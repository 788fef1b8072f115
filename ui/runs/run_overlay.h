// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of the pinned runs (results kept for comparison) drawn over the plot of a page.
#pragma once

#include <algorithm>
#include <optional>

#include "ui/runs/runs.h"
#include "ui/text/shown_units.h"

namespace drillwave {

/// Returns the units in which the results of a pinned run are shown beside the present blow. They have the
/// same names as `units`, but factors that follow from the scales of the run instead of `scales`. Nothing if
/// `units` are physical and the run is dimensionless.
std::optional<ShownUnits> unitsOf(const SolvedBlow& run, const ShownUnits& units, const Scales& scales);

/// Returns whether `a` and `b` show all quantities in units with the same names. Factors are not compared.
/// For one run, equal names mean equal factors, except for rounding.
bool areSameUnits(const ShownUnits& a, const ShownUnits& b);

/// Pinned run (a result kept for comparison) with the curves that a page draws for it over its own.
template <class Curves>
struct RunOverlay {
    int number = 0;  ///< number of the run (from 0), which decides its letter, colour and dash pattern
    QString title;
    /// Blow of the run; a weak pointer, so that the curves do not keep it in memory.
    std::weak_ptr<const SolvedBlow> blow;
    ShownUnits units;
    std::shared_ptr<const Curves> curves;
    /// Returns whether two overlays look the same when drawn. Curves are compared by their address: shared
    /// curves belong to the same blow in the same units.
    bool operator==(const RunOverlay& other) const {
        return number == other.number && title == other.title && curves == other.curves;
    }
};

/// Returns the curves to draw for all solved runs that are set to be shown, in the units of the present blow.
/// Curves in `made`, from an earlier call, are reused if run and units are the same. Others are computed by
/// `make` from a blow and its units. May be called on any thread.
template <class Curves, class Make>
std::vector<RunOverlay<Curves>> runOverlays(const RunList& runs, const SolvedBlow& now,
                                            const std::vector<RunOverlay<Curves>>& made, const Make& make) {
    std::vector<RunOverlay<Curves>> overlays;
    for (const Run& run : runs) {
        if (!run.isShown || !run.isSolved()) continue;
        const std::optional<ShownUnits> units = unitsOf(*run.blow, now.units, now.scales);
        if (!units) continue;
        const auto same = std::ranges::find_if(made, [&](const RunOverlay<Curves>& each) {
            return each.blow.lock() == run.blow && areSameUnits(each.units, *units);
        });
        if (same == made.end())
            overlays.push_back({.number = run.number,
                                .title = run.title(),
                                .blow = run.blow,
                                .units = *units,
                                .curves = std::make_shared<const Curves>(make(*run.blow, *units))});
        else
            overlays.push_back({run.number, run.title(), same->blow, same->units, same->curves});
    }
    return overlays;
}

}  // namespace drillwave
