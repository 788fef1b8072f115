// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/run_pen.h"

#include <QIcon>
#include <QPainter>
#include <QPixmap>

#include "ui/text/lightness.h"

namespace drillwave {
namespace {

constexpr int kinds = 6;

// Brown, magenta, teal, olive, violet, grey.
constexpr QRgb runsOnLight[kinds] = {0xff8a5a00, 0xffb0206e, 0xff00707c, 0xff5c6b00, 0xff5a4bc8, 0xff5a5a5a};
constexpr QRgb runsOnDark[kinds] = {0xffe0b050, 0xffff8ac0, 0xff5fd0dc, 0xffc3d24a, 0xffb3a8ff, 0xffc0c0c0};

const QList<qreal>& dashes(int kind) {
    static const QList<qreal> all[kinds] = {{7, 3}, {1.5, 2}, {9, 3, 1.5, 3}, {15, 4}, {9, 2, 1.5, 2, 1.5, 2},
                                            {4, 4}};
    return all[kind % kinds];
}

}  // namespace

QPen runPen(int number, const PlotStyle& style) {
    const int colour = number % kinds;
    QPen pen(QColor::fromRgb((isDark(style.background) ? runsOnDark : runsOnLight)[colour]), style.lineWidth);
    pen.setDashPattern(dashes(number + number / kinds));
    pen.setCapStyle(Qt::FlatCap);
    pen.setJoinStyle(Qt::BevelJoin);
    return pen;
}

QIcon runIcon(int number, const QPalette& palette, QSize size) {
    constexpr qreal scale = 2;  // sharp on a screen with two pixels a point
    QPixmap picture(size * scale);
    picture.setDevicePixelRatio(scale);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setPen(runPen(number, PlotStyle::forScreen(palette, {})));
    painter.drawLine(QPointF(0, size.height() / 2.0), QPointF(size.width(), size.height() / 2.0));
    return QIcon(picture);
}

}  // namespace drillwave
