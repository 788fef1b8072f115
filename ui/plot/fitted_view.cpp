// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/fitted_view.h"

#include <qcustomplot.h>

#include <QScopedValueRollback>

namespace drillwave {

void FittedView::watch(const QCPAxis* axis) {
    connect(axis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this, &FittedView::leave);
}

void FittedView::leave() {
    if (m_setting || m_empty) return;
    m_fitted = false;
    emit chosen();
}

void FittedView::fit(const std::function<void()>& setRanges) {
    m_fitted = true;
    adjust(setRanges);
}

void FittedView::adjust(const std::function<void()>& setRanges) {
    const QScopedValueRollback<bool> setting(m_setting, true);
    setRanges();
}

}  // namespace drillwave
