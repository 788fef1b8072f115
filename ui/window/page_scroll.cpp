// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/page_scroll.h"

#include <QScrollBar>
#include <algorithm>

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
    setFocusPolicy(Qt::NoFocus);
}

QSize PageScroll::sizeHint() const {
    return widget()->sizeHint();
}

QSize PageScroll::minimumSizeHint() const {
    return {std::min(neededWidth(), leastWidth), leastLines * fontMetrics().height()};
}

int PageScroll::neededWidth() const {
    return widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width();
}

}  // namespace drillwave
