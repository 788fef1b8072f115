// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of the pinned runs (results kept for comparison) drawn over the plot of a page.
#pragma once

#include <algorithm>
#include <optional>

#include "ui/runs/runs.h"
#include "ui/text/shown_units.h"

namespace drillwave {

/// Returns the units for the dimensionless numbers of a pinned run, with the same names as `units`, those of
/// the present blow. The factors follow from the scales of the run instead of `scales`. Nothing if `units`
/// are physical and the run is dimensionless.
std::optional<ShownUnits> unitsOf(const SolvedBlow& run, const ShownUnits& units, const Scales& scales);

/// Returns whether all units of `a` and `b` have the same names. Factors are not compared: for one run they
/// follow from the names, except for rounding.
bool areSameUnits(const ShownUnits& a, const ShownUnits& b);

/// Pinned run (a result kept for comparison) with the curves that a page draws for it.
template <class Curves>
struct RunOverlay {
    int number = 0;  ///< number of the run (from 0), which decides its letter, colour and dash pattern
    QString title;
    /// Blow of the run; a weak pointer, so that the curves do not keep it in memory.
    std::weak_ptr<const SolvedBlow> blow;
    ShownUnits units;
    std::shared_ptr<const Curves> curves;
    /// Returns whether two overlays draw the same. Equal curves mean the same blow in the same units.
    bool operator==(const RunOverlay& other) const {
        return number == other.number && title == other.title && curves == other.curves;
    }
};

/// Returns the overlays of the solved runs that are shown, in the units of the present blow. Overlays in
/// `made` are reused; `make` computes the curves of the others from a blow and its units. May be called on
/// any thread.
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
