// SPDX-License-Identifier: GPL-3.0-or-later
// Stated effect of the samples of a blow that are left out, against blows that need none.
#include <QTest>

#include <cmath>
#include <numbers>

#include "core/blow/blow.h"
#include "core/blow/thinned_blow.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"

using namespace drillwave;

namespace {

/// A half sine of 200 us and 300 kN.
Samples halfSine(int count) {
    Samples samples;
    for (int i = 0; i <= count; ++i) {
        const double share = double(i) / count;
        samples.time.push_back(200e-6 * share);
        samples.value.push_back(i == count ? 0 : 300 * std::sin(std::numbers::pi * share));
    }
    return samples;
}

SignalRecipe recipeOf(std::size_t points) {
    SignalRecipe recipe;
    recipe.use = SignalUse::blow;
    recipe.forcePerNumber = 1000;
    recipe.points = points;
    return recipe;
}

std::optional<ThinningEffect> effectOf(const Scenario& scenario, const Samples& samples, std::size_t points) {
    const SignalRecipe recipe = recipeOf(points);
    return thinningEffect(scenario, samples, recipe, shapedSignal(samples, recipe));
}

}  // namespace

class TestThinningEffect : public QObject {
    Q_OBJECT

  private slots:
    void theChangeIsThatAgainstTheWholeBlow() {
        Scenario scenario;
        scenario.pulse.shape = PulseShape::halfSine;
        scenario.pulse.duration = 200e-6;
        scenario.pulse.impulse = 300e3 * 200e-6 * 2 / std::numbers::pi;
        const double whole = solveBlow(scenario, {}, Detail::cor).impact.cor;
        const Samples samples = halfSine(20'000);
        double before = 1;
        for (const std::size_t points : {20U, 60U, 200U}) {
            const std::optional<ThinningEffect> effect = effectOf(scenario, samples, points);
            QVERIFY(effect);
            // 20 000 straight lines make less than 1e-8 of e.
            QVERIFY2(std::abs(effect->cor - effect->change - whole) < 1e-8,
                     QByteArray::number(effect->cor - effect->change - whole));
            QVERIFY(std::abs(effect->change) > effect->error && effect->error < 1e-12);
            QVERIFY(std::abs(effect->change) < before);
            before = std::abs(effect->change);
        }
    }

    void whereNothingIsLeftOutThereIsNothingToTell() {
        QVERIFY(!effectOf(Scenario(), halfSine(100), 101));
        const Scenario string = parseScenario(findExample("t38_string")->text, "t38_string").scenario;
        QVERIFY(!effectOf(string, halfSine(1000), 101));
    }
};

QTEST_GUILESS_MAIN(TestThinningEffect)
#include "tst_thinning_effect.moc"
