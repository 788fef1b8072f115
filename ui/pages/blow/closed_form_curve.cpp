// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/blow/closed_form_curve.h"

#include "core/wave/closed/closed_form.h"
#include "core/wave/field/wave_curves.h"

namespace drillwave {

std::optional<ClosedFormCurve> closedFormCurve(const Problem& problem, const ShownUnits& units,
                                               double timeEnd) {
    const Impact impact = solveClosedForm(problem, Detail::histories);
    if (!impact.isSolved()) return {};
    const SampledHistory history = sampleHistory(impact);
    return ClosedFormCurve{
        historyData(shownPoints(history.time, history.force, units.time, units.force), timeEnd, Tail::kept),
        impact.corError};
}

}  // namespace drillwave
