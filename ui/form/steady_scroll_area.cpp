// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/steady_scroll_area.h"

#include <QEvent>
#include <QScrollBar>
#include <algorithm>

namespace drillwave {
namespace {

constexpr int mostHeight = 900;   // asked for; the rest is scrolled [px]
constexpr int leastHeight = 200;  // [px]

}  // namespace

SteadyScrollArea::SteadyScrollArea(QWidget* parent) : QScrollArea(parent) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
}

// Content that has become wider needs a wider area; Qt would leave the width as it was.
bool SteadyScrollArea::event(QEvent* event) {
    if (event->type() == QEvent::LayoutRequest) updateGeometry();
    return QScrollArea::event(event);
}

QSize SteadyScrollArea::around(const QSize& content, int height) const {
    return {content.width() + verticalScrollBar()->sizeHint().width() + 2, height};
}

QSize SteadyScrollArea::sizeHint() const {
    const QSize content = widget()->sizeHint();
    return around(content, std::min(content.height(), mostHeight));
}

QSize SteadyScrollArea::minimumSizeHint() const {
    return around(widget()->minimumSizeHint(), leastHeight);
}

}  // namespace drillwave
