// SPDX-License-Identifier: GPL-3.0-or-later
// Panels of curves drawn from their data: figures of the paper, sweeps.
#pragma once

#include <QByteArray>
#include <QLocale>
#include <QString>

#include "core/study/paper/figure_data.h"
#include "ui/export/pictures.h"
#include "ui/plot/plot_style.h"

class QCustomPlot;

namespace drillwave {

/// Returns a text of a data file as it is printed: "gamma" as γ, "k0" with its index.
QString figureText(const std::string& text);

/// Fills a plot, of whatever size, with nothing but the panels below each other.
void layOutPanels(QCustomPlot& plot, const std::vector<FigurePanel>& panels, const PlotStyle& style,
                  const QLocale& locale);

/// The panels below each other, in a format of plotFormats(), on white, text in the C locale; 160 mm wide.
/// Requires a QApplication (any platform, also offscreen). Empty when it could not be drawn.
QByteArray drawFigure(const Figure& figure, const QString& format);

/// Draws other panels in the same way, see renderPictures().
Pictures drawPanels(const std::vector<FigurePanel>& panels, const QString& title, const PictureOrder& order,
                    const QLocale& locale = QLocale::c());

}  // namespace drillwave
