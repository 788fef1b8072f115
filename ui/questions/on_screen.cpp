// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/questions/on_screen.h"

#include <QGuiApplication>
#include <QScreen>
#include <QWidget>
#include <algorithm>

namespace drillwave {
namespace {

constexpr int graspable = 80;  // pixels of the title that must be on the screen

// The screen that shows most of the frame, or the first one.
QRect roomFor(const QRect& frame) {
    QRect best = QGuiApplication::primaryScreen()->availableGeometry();
    int most = 0;
    for (const QScreen* screen : QGuiApplication::screens()) {
        const QRect shown = screen->availableGeometry() & frame;
        if (shown.width() * shown.height() <= most) continue;
        most = shown.width() * shown.height();
        best = screen->availableGeometry();
    }
    return best;
}

}  // namespace

QSize firstSize(const QWidget& window, const QSize& wanted) {
    constexpr QSize usualFrame{16, 48};  // edges, and the title above
    return wanted.boundedTo(window.screen()->availableSize() - usualFrame);
}

void fitOnScreen(QWidget& window) {
    const QRect room = window.screen()->availableGeometry();
    const QSize frame = window.frameGeometry().size() - window.size();
    window.resize(window.size().boundedTo(room.size() - frame));
    const QRect outside = window.frameGeometry();
    const int x = std::max(room.left(), std::min(outside.x(), room.right() + 1 - outside.width()));
    const int y = std::max(room.top(), std::min(outside.y(), room.bottom() + 1 - outside.height()));
    if (QPoint(x, y) != outside.topLeft()) window.move(x, y);
}

void keepOnScreen(QWidget& window) {
    const QRect frame = window.frameGeometry();
    const QRect room = roomFor(frame);
    window.resize(window.size().boundedTo(room.size()));
    const int x = std::clamp(frame.x(), room.left() - frame.width() + graspable, room.right() - graspable);
    const int y = std::clamp(frame.y(), room.top(), room.bottom() - graspable);
    if (QPoint(x, y) != frame.topLeft()) window.move(x, y);
}

}  // namespace drillwave
