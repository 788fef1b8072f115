// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/blow/measured_force.h"

#include <algorithm>

#include "core/blow/blow_waves.h"
#include "core/model/blow_traits.h"
#include "ui/pages/blow/blow_page.h"
#include "ui/text/number_text.h"

namespace drillwave {

double shareAt(const Scenario& scenario, double x) {
    return std::clamp(x / chainProperties(scenario).length, hammerRear(scenario.drillString), 1.0);
}

ComputedForce computedForce(const Blow& blow, const MeasuredSignal& signal, double end) {
    const Scales scales = scalesOf(blow.scenario);
    const double share = shareAt(blow.scenario, signal.place);
    const bool isInside = signal.quantity == MeasuredQuantity::normalForce;
    const auto force = [=, waves = BlowWaves(blow)](double time) {
        const double t = std::min(time / scales.time, waves.end());
        return scales.force * (isInside ? waves.value(WaveQuantity::force, share, t) : waves.impactForce(t));
    };
    return {force, end};
}

std::optional<Misfit> misfitOf(const MeasuredSignal& signal, const ComputedForce& computed) {
    return misfitOf(signal.points, signal.timeShift, computed.at, computed.end);
}

QString misfitText(const Misfit& misfit, const Scenario& scenario, const ShownUnits& units,
                   const QLocale& locale) {
    const Scales scales = scalesOf(scenario);
    const auto force = [&](double newtons) {
        return quantityText(newtons / scales.force, units.force, locale);
    };
    QString text =
        BlowPage::tr("rms %1 · peaks differ by %2").arg(force(misfit.rms), force(misfit.peakDifference));
    if (misfit.computedPeak > 0)
        text += QStringLiteral(" (%1 %)").arg(
            locale.toString(100 * misfit.peakDifference / misfit.computedPeak, 'f', 1));
    if (misfit.lag)
        text += BlowPage::tr(" · lag %1").arg(quantityText(*misfit.lag / scales.time, units.time, locale));
    return text;
}

}  // namespace drillwave
