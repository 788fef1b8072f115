// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/view_history.h"

#include <algorithm>

#include "ui/plot/axis_view.h"

namespace drillwave {
namespace {

constexpr qsizetype mostViews = 100;
constexpr qint64 burstMilliseconds = 500;

}  // namespace

ViewHistory::View ViewHistory::present() const {
    View view;
    for (const QCPAxisRect* rect : m_plot.axisRects())
        for (QCPAxis* axis : {rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft)})
            if (axis) view.append({axis, axis->range(), axis->scaleType(), axis->label()});
    return view;
}

bool ViewHistory::isStale(const View& view) {
    return std::any_of(view.begin(), view.end(), [](const AxisState& state) {
        return !state.axis || state.axis->label() != state.label;
    });
}

bool ViewHistory::isShown(const View& view) {
    return std::all_of(view.begin(), view.end(), [](const AxisState& state) {
        return state.axis->range() == state.range && state.axis->scaleType() == state.scale;
    });
}

void ViewHistory::remember() {
    m_burst.invalidate();
    m_views.append(present());
    if (m_views.size() > mostViews) m_views.removeFirst();
}

void ViewHistory::rememberBurst() {
    if (!m_burst.isValid() || m_burst.elapsed() > burstMilliseconds) remember();
    m_burst.start();
}

bool ViewHistory::canGoBack() const {
    return std::any_of(m_views.begin(), m_views.end(),
                       [](const View& view) { return !isStale(view) && !isShown(view); });
}

void ViewHistory::goBack() {
    m_burst.invalidate();
    while (!m_views.isEmpty()) {
        const View view = m_views.takeLast();
        if (isStale(view) || isShown(view)) continue;
        for (const AxisState& state : view) {
            setScale(*state.axis, state.scale);
            state.axis->setRange(state.range);
        }
        return;
    }
}

}  // namespace drillwave
