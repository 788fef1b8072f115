// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/pictures.h"

#include "ui/plot/plot_rendering.h"

namespace drillwave {
namespace {

// Known before anything is drawn; empty where all formats are.
QString unknownFormat(const std::vector<std::string>& formats) {
    for (const std::string& each : formats)
        if (const QString format = QString::fromStdString(each); !plotFormats().contains(format))
            return QStringLiteral("plot format \"%1\" is not known; use %2")
                .arg(format, plotFormats().join(QStringLiteral(", ")));
    return {};
}

}  // namespace

Pictures renderPictures(QCustomPlot& plot, Millimetres size, const QString& title,
                        const PictureOrder& order) {
    Pictures pictures{.files = {}, .problem = unknownFormat(order.formats)};
    if (!pictures.problem.isEmpty()) return pictures;
    for (const std::string& format : order.formats) {
        if (order.stop.stop_requested()) return pictures;
        const std::string name = order.stem + "." + format;
        const QByteArray bytes = renderPlot(plot, size, QString::fromStdString(format), title, standardDpi,
                                            QString::fromStdString(order.mark));
        if (bytes.isEmpty())
            return {{},
                    QStringLiteral("%1: not written, the plot could not be drawn")
                        .arg(QString::fromStdString(name))};
        pictures.files.push_back({name, bytes.toStdString()});
    }
    return pictures;
}

}  // namespace drillwave
