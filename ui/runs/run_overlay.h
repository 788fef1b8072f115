// SPDX-License-Identifier: GPL-3.0-or-later
// What a page lays over its plot of the pinned runs.
#pragma once

#include <algorithm>
#include <optional>

#include "ui/runs/run.h"
#include "ui/text/shown_units.h"

namespace drillwave {

/// The units on show for the dimensionless numbers of a run: the same ones, by its scales. `units` and
/// `scales` are those of the present blow. nullopt where it has physical units and the run has none.
std::optional<ShownUnits> unitsOf(const SolvedBlow& run, const ShownUnits& units, const Scales& scales);

/// One run with what a page draws of it.
template <class Curves>
struct RunOverlay {
    int number = 0;  ///< of its letter, colour and dash
    QString title;
    SolvedBlowPtr blow;
    ShownUnits units;
    std::shared_ptr<const Curves> curves;
    bool operator==(const RunOverlay&) const = default;
};

/// Of the solved runs that are to be shown, in the units of the present blow. Those that `made` holds already
/// are taken from there; `make` makes the others from a blow and its units. On any thread.
template <class Curves, class Make>
std::vector<RunOverlay<Curves>> runOverlays(const RunList& runs, const SolvedBlow& now,
                                            const std::vector<RunOverlay<Curves>>& made, const Make& make) {
    std::vector<RunOverlay<Curves>> overlays;
    for (const Run& run : runs) {
        if (!run.isShown || !run.isSolved()) continue;
        const std::optional<ShownUnits> units = unitsOf(*run.blow, now.units, now.scales);
        if (!units) continue;
        const auto same = std::ranges::find_if(made, [&](const RunOverlay<Curves>& each) {
            return each.blow == run.blow && each.units == *units;
        });
        auto curves =
            same == made.end() ? std::make_shared<const Curves>(make(*run.blow, *units)) : same->curves;
        overlays.push_back({run.number, run.title(), run.blow, *units, std::move(curves)});
    }
    return overlays;
}

}  // namespace drillwave
