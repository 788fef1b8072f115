// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing of panels of curves from their data: figures of the paper, and sweeps.
#pragma once

#include <QByteArray>
#include <QLocale>
#include <QString>

#include "core/study/paper/figure_data.h"
#include "ui/export/pictures.h"
#include "ui/plot/plot_style.h"

class QCustomPlot;

namespace drillwave {

/// Returns a label from a data file with Greek letters and subscripts: "gamma" becomes γ, "k0" gets a
/// subscript.
QString figureText(const std::string& text);

/// Replaces the contents of a plot by panels, one below the other, scaled to the size of the plot.
void layOutPanels(QCustomPlot& plot, const std::vector<FigurePanel>& panels, const PlotStyle& style,
                  const QLocale& locale);

/// Returns the panels of a figure, one below the other, as the bytes of a picture in one of the
/// plotFormats(). Empty if it could not be drawn. The picture is 160 mm wide, on white, with numbers in the C
/// locale. Requires a QApplication (any platform, also offscreen).
QByteArray drawFigure(const Figure& figure, const QString& format);

/// Returns pictures of the panels, one below the other, in the formats of `order`, 160 mm wide and on white.
/// See renderPictures(). Requires a QApplication (any platform, also offscreen).
Pictures drawPanels(const std::vector<FigurePanel>& panels, const QString& title, const PictureOrder& order,
                    const QLocale& locale = QLocale::c());

}  // namespace drillwave
