// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/program_icon.h"

#include <QByteArray>
#include <QPainter>
#include <QPixmap>
#include <QSvgRenderer>

#include "ui/window/icon_text.h"

namespace drillwave {

QImage programImage(int width) {
    QSvgRenderer drawing(QByteArray::fromRawData(iconText.data(), static_cast<qsizetype>(iconText.size())));
    QImage image(width, width, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    drawing.render(&painter);
    return image;
}

QIcon programIcon() {
    QIcon icon;
    for (const int width : iconWidths) icon.addPixmap(QPixmap::fromImage(programImage(width)));
    return icon;
}

}  // namespace drillwave
