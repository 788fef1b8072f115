// SPDX-License-Identifier: GPL-3.0-or-later
// Changes of the events of a blow: two adjacent doubles of one group between which one appears, vanishes or
// meets a front.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "core/wave/exact/exact_solver.h"
#include "tests/support/scene.h"

namespace drillwave::test {

/// A change of the events between `before` and `after`, which are adjacent doubles.
struct EventChange {
    Scene scene;
    double Groups::*group;
    double before, after;

    /// The scene at each of the `each` doubles on either side that a group may have.
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

/// Finds changes of events by bisection.
class EventChanges {
  public:
    /// Moves one of δ, β and τ, and bisects to a change of the events on the way: their kinds, or in every
    /// second scene also the breakpoints of the wave around them. None if they are the same at both ends, or
    /// the blow is too long for thousands.
    std::optional<EventChange> find(const Scene& scene, Chance& chance) {
        const bool hasGap = scene.shape != PulseShape::rigidBody;
        constexpr double Groups::*groups[] = {&Groups::delta, &Groups::beta, &Groups::tau};
        EventChange change{scene, groups[hasGap ? chance.below(3) : 1 + chance.below(2)], 0, 0};
        double& value = change.scene.groups.*change.group;
        change.before = value;
        change.after =
            change.group == &Groups::delta ? 3 * chance.fraction() : value * (1 + chance.fraction());
        const bool withFronts = !hasGap || chance.oneIn(2);  // a rigid body meets, unloads and parts for ever
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
    /// An event and how many breakpoints of the incident wave have arrived before it, where that is looked
    /// at.
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

    /// Each end of a segment of the hammer force comes back after every round trip.
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
