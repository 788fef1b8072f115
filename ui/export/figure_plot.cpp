// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/figure_plot.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

#include "core/archive/result_files.h"
#include "ui/plot/axis_rect.h"
#include "ui/plot/plot_rendering.h"
#include "ui/plot/plot_style.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

QCPRange rangeOf(const FigurePanel& panel, std::vector<double> FigureCurve::*values, double margin) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const FigureCurve& curve : panel.curves) {
        if (curve.line == FigureCurve::Line::none) continue;
        for (const double value : curve.*values) {
            if (!std::isfinite(value)) continue;
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    if (!(low < high)) {  // one value, or none
        const double centre = low == high ? low : 0;
        low = centre - std::max(1e-3 * std::abs(centre), 1e-6);
        high = centre + std::max(1e-3 * std::abs(centre), 1e-6);
    }
    const double room = margin * (high - low);
    return {low - room, high + room};
}

/// Adds dashes if all lines are solid, so that they differ not only in colour.
QPen penOf(const FigurePanel& panel, const FigureCurve& curve, const PlotStyle& style) {
    using Line = FigureCurve::Line;
    if (std::ranges::all_of(panel.curves, [](const FigureCurve& one) { return one.line == Line::solid; }))
        return style.linePen(curve.colour);
    QPen pen(style.lines[curve.colour % PlotStyle::lineKinds], style.lineWidth);
    pen.setCapStyle(Qt::FlatCap);
    if (curve.line == Line::dotted) pen.setDashPattern({1.5, 2});
    if (curve.line == Line::dashed) pen.setDashPattern({6, 3});
    return pen;
}

void addCurves(const FigurePanel& panel, QCPAxisRect& rect, QCPLegend& legend, const PlotStyle& style) {
    for (const FigureCurve& curve : panel.curves) {
        if (curve.line == FigureCurve::Line::none) continue;
        QCPGraph* graph =
            rect.parentPlot()->addGraph(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
        graph->setName(figureText(curve.label));
        graph->setAdaptiveSampling(false);
        graph->setData(QVector<double>(curve.x.begin(), curve.x.end()),
                       QVector<double>(curve.y.begin(), curve.y.end()), true);
        graph->setPen(penOf(panel, curve, style));
        graph->addToLegend(&legend);
    }
}

void setAxes(const FigurePanel& panel, QCPAxisRect& rect) {
    QCPAxis& x = *rect.axis(QCPAxis::atBottom);
    QCPAxis& y = *rect.axis(QCPAxis::atLeft);
    x.setLabel(figureText(panel.xLabel));
    y.setLabel(figureText(panel.yLabel));
    for (const auto side : {QCPAxis::atTop, QCPAxis::atRight}) rect.axis(side)->setTicks(false);
    x.setRange(rangeOf(panel, &FigureCurve::x, 0));
    if (panel.xFrom) x.setRangeLower(*panel.xFrom);
    y.setRange(rangeOf(panel, &FigureCurve::y, 0.06));
    if (!panel.logarithmicX) return;
    x.setScaleType(QCPAxis::stLogarithmic);
    x.setTicker(QSharedPointer<QCPAxisTickerLog>::create());
    x.setNumberFormat(QStringLiteral("g"));
    x.setNumberPrecision(6);
}

/// Adds an element below the others, as high as it needs to be or taking what height is left.
enum class Height { own, rest };
void addRow(QCustomPlot& plot, QCPLayoutElement* element, Height height) {
    const int row = plot.plotLayout()->rowCount();
    plot.plotLayout()->addElement(row, 0, element);
    if (height == Height::own) plot.plotLayout()->setRowStretchFactor(row, 1e-3);
}

void addTitle(QCustomPlot& plot, const std::string& text, const PlotStyle& style) {
    auto* title = new QCPTextElement(&plot, figureText(text));
    title->setTextFlags(Qt::AlignLeft | Qt::AlignVCenter);
    title->setMargins(QMargins(8, 4, 0, 0));
    style.applyTo(*title);
    addRow(plot, title, Height::own);
}

void addPanel(QCustomPlot& plot, const FigurePanel& panel, const PlotStyle& style) {
    if (!panel.title.empty()) addTitle(plot, panel.title, style);
    QCPAxisRect* rect = newAxisRect(plot, Sides::linked);
    rect->setMinimumMargins(QMargins(4, 6, 16, 2));
    addRow(plot, rect, Height::rest);
    auto* legend = new QCPLegend;
    legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
    legend->setWrap(panel.curves.size() > 4 ? 2 : 4);
    legend->setIconSize(34, 12);
    addRow(plot, legend, Height::own);
    legend->setLayer(QStringLiteral("legend"));
    addCurves(panel, *rect, *legend, style);
    setAxes(panel, *rect);
    style.applyTo(*rect);
    style.applyTo(*legend);
}

Millimetres sizeOf(const std::vector<FigurePanel>& panels) {
    constexpr double width = 160, panelHeight = 95;
    return {width, panelHeight * static_cast<double>(panels.size())};
}

void layOutOnPaper(QCustomPlot& plot, const std::vector<FigurePanel>& panels, const QLocale& locale) {
    layOutPanels(plot, panels, PlotStyle::forPaper(), locale);
}

}  // namespace

QString figureText(const std::string& text) {
    QString result = QString::fromStdString(text);
    const std::pair<const char*, const char*> symbols[] = {
        {"beta", "β"},  {"gamma", "γ"}, {"delta", "δ"}, {"tau", "τ"},   {"/t0", "/t₀"}, {"/F0", "/F₀"},
        {"/I0", "/I₀"}, {"k0", "k₀"},   {"N0p", "N₀ₚ"}, {"N1n", "N₁ₙ"}, {"N2p", "N₂ₚ"}, {"N3n", "N₃ₙ"}};
    for (const auto& [plain, symbol] : symbols)
        result.replace(QLatin1String(plain), QString::fromUtf8(symbol));
    return result;
}

void layOutPanels(QCustomPlot& plot, const std::vector<FigurePanel>& panels, const PlotStyle& style,
                  const QLocale& locale) {
    plot.setLocale(locale);
    plot.setAutoAddPlottableToLegend(false);
    plot.clearGraphs();
    plot.plotLayout()->clear();
    plot.setBackground(style.background);
    for (const FigurePanel& panel : panels) addPanel(plot, panel, style);
}

QByteArray drawFigure(const Figure& figure, const QString& format) {
    QCustomPlot plot;
    layOutOnPaper(plot, figure.panels, QLocale::c());
    return renderPlot(plot, sizeOf(figure.panels), format, QStringLiteral("Fig. %1").arg(figure.number),
                      standardDpi, fromView(figureMark));
}

Pictures drawPanels(const std::vector<FigurePanel>& panels, const QString& title, const PictureOrder& order,
                    const QLocale& locale) {
    QCustomPlot plot;
    layOutOnPaper(plot, panels, locale);
    return renderPictures(plot, sizeOf(panels), title, order);
}

}  // namespace drillwave
