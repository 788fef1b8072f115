// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/steady_scroll_area.h"

#include <QScrollBar>

namespace drillwave {

SteadyScrollArea::SteadyScrollArea(QWidget* parent) : QScrollArea(parent) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

// The viewport is as wide as before then, so that this comes to an end.
void SteadyScrollArea::resizeEvent(QResizeEvent* event) {
    QScrollArea::resizeEvent(event);
    const QScrollBar* bar = verticalScrollBar();
    const bool isNeeded = bar->minimum() < bar->maximum();
    const QMargins margins(0, 0, isNeeded ? 0 : bar->sizeHint().width(), 0);
    if (margins != viewportMargins()) setViewportMargins(margins);
}

}  // namespace drillwave
