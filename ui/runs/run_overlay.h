// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of the pinned runs laid over the plot of a page.
#pragma once

#include <algorithm>
#include <optional>

#include "ui/runs/runs.h"
#include "ui/text/shown_units.h"

namespace drillwave {

/// The units on show for the dimensionless numbers of a run: the same ones, by its scales. `units` and
/// `scales` are those of the present blow. nullopt where it has physical units and the run has none.
std::optional<ShownUnits> unitsOf(const SolvedBlow& run, const ShownUnits& units, const Scales& scales);

/// Whether both are named alike. The factors are not looked at: of one run they follow from the names, but
/// for their last digits.
bool areSameUnits(const ShownUnits& a, const ShownUnits& b);

/// One run with the curves that a page draws of it.
template <class Curves>
struct RunOverlay {
    int number = 0;  ///< of its letter, colour and dash
    QString title;
    std::weak_ptr<const SolvedBlow> blow;  ///< what is drawn does not keep it
    ShownUnits units;
    std::shared_ptr<const Curves> curves;
    /// Compares overlays: of the same blow in the same units if the curves are the same.
    bool operator==(const RunOverlay& other) const {
        return number == other.number && title == other.title && curves == other.curves;
    }
};

/// Returns overlays for the solved runs on show, in the units of the present blow. Takes those in `made` from
/// there; `make` makes the others from a blow and its units. On any thread.
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
