// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/page_scroll.h"

#include <QScrollBar>

#include "ui/window/page_tabs.h"

namespace drillwave {
namespace {

constexpr int leastLines = 10;  // of text: what is lower is of no use

}  // namespace

PageScroll::PageScroll(PageTabs* pages, QWidget* parent) : QScrollArea(parent) {
    setObjectName(QStringLiteral("pageScroll"));
    setWidget(pages);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
}

QSize PageScroll::sizeHint() const {
    return widget()->sizeHint();
}

QSize PageScroll::minimumSizeHint() const {
    return {widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width(),
            leastLines * fontMetrics().height()};
}

}  // namespace drillwave
