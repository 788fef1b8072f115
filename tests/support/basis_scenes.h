// SPDX-License-Identifier: GPL-3.0-or-later
// Test blows for which the closed form may be wrong: few reflections, and inputs near divisions by zero,
// cancellation or simultaneous events.
#pragma once

#include <optional>

#include "tests/support/event_change.h"
#include "tests/support/scene.h"

namespace drillwave::test {

/// Random blows of every pulse shape, each determined by its number. The product βτ is 0.2 … 1e6, in half of
/// them on rods shorter than the pulse. The elasticity γ is 0.05 … 1, often above 0.7, nearly 1, or 1. Gaps
/// are often whole numbers or nearly so. Exponential pulses often have β near their decay rate, and some
/// blows have grazing contacts.
class BasisScenes {
  public:
    /// Starts a sequence of blows, of which each `seed` gives another; `only` restricts it to one pulse
    /// shape.
    explicit BasisScenes(unsigned seed, std::optional<PulseShape> only = {}) : m_seed(seed), m_only(only) {}

    Scene scene(unsigned number) {
        Chance chance(m_seed * 1'000'000'007ULL + number);
        Scene scene;
        scene.shape = m_only ? *m_only : PulseShape(number % 8);
        scene.impedanceRatio = chance.logarithmic(0.05, 20);
        scene.table = {.points = int(chance.logarithmic(2, 300)), .seed = chance.below(1'000'000)};
        drawGroups(chance, scene);
        if (chance.oneIn(10)) graze(chance, scene);
        return scene;
    }

  private:
    static double near(Chance& chance, double value) {
        const double distance = chance.logarithmic(1e-16, 1e-3);
        return std::max(0.0, value + (chance.oneIn(2) ? distance : -distance));
    }

    static void drawGroups(Chance& chance, Scene& scene) {
        Groups& g = scene.groups;
        g.gamma = drawGamma(chance);
        g.tau = chance.oneIn(2) ? chance.logarithmic(0.05, 0.5) : chance.logarithmic(0.5, 20);
        if (chance.oneIn(8)) g.tau = 0.5 * (1 + chance.below(8));
        if (chance.oneIn(16)) g.tau = 0.5 / (1 + chance.below(8));
        // more values of medium βτ, where reflections overlap
        const double softness = chance.oneIn(3) ? chance.logarithmic(0.2, 1e6) : chance.logarithmic(0.2, 100);
        g.beta = softness / g.tau;
        if (scene.shape == PulseShape::exponential && chance.oneIn(3)) {
            const double away = chance.logarithmic(1e-12, 0.2);
            g.beta = (chance.oneIn(2) ? 1 + away : 1 - away) * (chance.oneIn(2) ? 1 : g.gamma);
            if (chance.oneIn(16)) g.beta = 1;
            g.tau = chance.logarithmic(std::max(0.05, 0.2 / g.beta), 20);
        }
        switch (chance.below(5)) {
            case 0:
                g.delta = 0;
                break;
            case 1:
                g.delta = chance.below(4);
                break;
            case 2:
                g.delta = near(chance, chance.below(4));
                break;
            case 3:
                g.delta = chance.logarithmic(1e-14, 100);
                break;
            default:
                g.delta = 3 * chance.fraction();
        }
        if (scene.shape == PulseShape::rigidBody) g.delta = 0;
    }

    static double drawGamma(Chance& chance) {
        switch (chance.below(8)) {
            case 0:
            case 1:
                return 1;
            case 2:
                return 1 - chance.logarithmic(1e-12, 0.3);
            case 3:
            case 4:
                return 0.7 + 0.3 * chance.fraction();
            default:
                return chance.logarithmic(0.05, 0.7);
        }
    }

    /// Changes one group to a value at which the sequence of events changes, or within 1e-16 to 1e-3
    /// (relative) of it.
    void graze(Chance& chance, Scene& scene) {
        const std::optional<EventChange> change = m_changes.find(scene, chance);
        if (!change) return;
        const double here = change->before;
        scene.groups.*change->group = chance.oneIn(4) ? here : here * near(chance, 1);
    }

    unsigned m_seed;
    std::optional<PulseShape> m_only;
    EventChanges m_changes;
};

}  // namespace drillwave::test
