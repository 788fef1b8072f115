// SPDX-License-Identifier: GPL-3.0-or-later
// Search for a value at which the sequence of events in a blow changes: an event appears, vanishes or
// coincides with a wave front.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "core/wave/exact/exact_solver.h"
#include "tests/support/scene.h"

namespace drillwave::test {

/// Change of the sequence of events between the values `before` and `after` of a group, two adjacent doubles.
struct EventChange {
    Scene scene;
    double Groups::*group;
    double before, after;

    /// Returns the blows at the `each` nearest doubles on either side of the change.
    std::vector<Scene> neighbours(int each) const {
        std::vector<Scene> scenes;
        for (const bool behind : {false, true}) {
            double value = behind ? after : before;
            const double away = behind == (before < after) ? std::numeric_limits<double>::infinity() : 0;
            for (int i = 0; i < each; ++i, value = std::nextafter(value, away)) {
                scenes.push_back(scene);
                scenes.back().groups.*group = value;
                if (value == away) break;
            }
        }
        return scenes;
    }
};

/// Search by bisection for changes in the sequence of events.
class EventChanges {
  public:
    /// Changes δ, β or τ at random, and returns a change of events on the way, found by bisection. Events are
    /// compared by kind, in every second blow also by the number of wave fronts that arrived before. Nothing
    /// if the events do not differ, or if the blow takes too long.
    std::optional<EventChange> find(const Scene& scene, Chance& chance) {
        const bool hasGap = scene.shape != PulseShape::rigidBody;
        constexpr double Groups::*groups[] = {&Groups::delta, &Groups::beta, &Groups::tau};
        EventChange change{scene, groups[hasGap ? chance.below(3) : 1 + chance.below(2)], 0, 0};
        double& value = change.scene.groups.*change.group;
        change.before = value;
        change.after =
            change.group == &Groups::delta ? 3 * chance.fraction() : value * (1 + chance.fraction());
        // A rigid body always has the same events (contact, unloading, separation): only the fronts differ.
        const bool withFronts = !hasGap || chance.oneIn(2);
        const auto eventsAt = [&](double wanted) {
            value = wanted;
            return events(change.scene, withFronts);
        };
        const auto eventsBefore = eventsAt(change.before);
        if (!eventsBefore || eventsAt(change.after) == eventsBefore) return {};
        for (;;) {
            const double middle = (change.before + change.after) / 2;
            if (middle == change.before || middle == change.after) break;
            (eventsAt(middle) == eventsBefore ? change.before : change.after) = middle;
        }
        if (!eventsAt(change.after)) return {};
        return change;
    }

  private:
    /// Event, and the number of fronts of the incident wave that arrived before it (0 if not counted).
    struct Event {
        ContactEvent kind;
        double fronts;
        bool operator==(const Event&) const = default;
    };

    std::optional<std::vector<Event>> events(const Scene& scene, bool withFronts) {
        const Problem problem = problemOf(scene);
        const Impact impact = m_solver.solve(problem, Detail::events);
        if (impact.outcome != Outcome::rebounded) return {};
        std::vector<Event> events;
        for (const ImpactEvent& event : impact.events)
            events.push_back(
                {event.kind, withFronts ? frontsBefore(problem, event.time - impact.frontArrival) : 0});
        return events;
    }

    /// Returns the number of wave fronts up to a time. Each end of a segment of the hammer force returns
    /// after every round trip.
    static double frontsBefore(const Problem& problem, double time) {
        const auto comes = [&](double start) {
            return time < start ? 0 : 1 + std::floor((time - start) / (2 * problem.transitTime()));
        };
        double fronts = comes(problem.force().end);
        for (const PulseSegment& segment : problem.force().segments) fronts += comes(segment.start);
        return fronts;
    }

    ExactSolver m_solver{3000};
};

}  // namespace drillwave::test
