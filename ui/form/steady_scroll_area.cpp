// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/steady_scroll_area.h"

namespace drillwave {

SteadyScrollArea::SteadyScrollArea(QWidget* parent) : QScrollArea(parent) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
}

}  // namespace drillwave
