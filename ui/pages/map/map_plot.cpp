// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/map/map_plot.h"

#include <algorithm>
#include <cmath>

#include "ui/pages/map/map_contours.h"
#include "ui/pages/map/map_crosshair.h"
#include "ui/pages/map/map_presets.h"
#include "ui/pages/study/output_box.h"
#include "ui/pages/study/parameter_names.h"
#include "ui/plot/curve_graph.h"
#include "ui/plot/number_ticks.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr double cutShare = 0.28;  // of the map's size

void setKind(QCPAxis* axis, SweepAxis::Kind kind) {
    const bool logarithmic = kind == SweepAxis::Kind::logarithmic;
    axis->setScaleType(logarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
    axis->setTicker(logarithmic ? QSharedPointer<QCPAxisTicker>(new NumberTicks<QCPAxisTickerLog>)
                                : QSharedPointer<QCPAxisTicker>(new NumberTicks<QCPAxisTicker>));
}

QCPRange rangeOf(const SweepAxis& axis, double factor) {
    QCPRange range(axis.start * factor, axis.stop * factor);
    range.normalize();
    if (range.size() > 0) return range;
    const double room = range.lower == 0 ? 1 : std::abs(range.lower) / 20;  // a map of one value
    return {range.lower - room, range.upper + room};
}

}  // namespace

MapPlot::MapPlot(QCustomPlot* plot) : StudyFrame(plot) {
    layOutAnew();
    addRects();
    m_raster = new MapRaster(plot, m_rect);
    m_raster->setLayer(QStringLiteral("background"));
    linkAxes();
    addCuts();
    m_contours = std::make_unique<MapContours>(m_rect);
    m_presets = std::make_unique<MapPresets>(m_rect);
    m_crosshair = new MapCrosshair(plot, m_rect, m_below, m_beside);
    addRunMarks();
    m_view->setEmpty(true);
    setStyle(PlotStyle::forPaper());
    m_bar->setVisible(false);
}

MapPlot::~MapPlot() = default;

void MapPlot::addRects() {
    view(newAxisRect(*m_plot, Sides::free));
    m_below = newAxisRect(*m_plot, Sides::free);
    m_beside = newAxisRect(*m_plot, Sides::free);
    m_bar = new QCPColorScale(m_plot);
    m_bar->setType(QCPAxis::atRight);
    m_bar->setBarWidth(14);
    m_bar->setRangeDrag(false);
    m_bar->setRangeZoom(false);
    QCPLayoutGrid* grid = m_plot->plotLayout();
    grid->addElement(0, 0, m_rect);
    grid->addElement(0, 1, m_beside);
    grid->addElement(0, 2, m_bar);
    grid->addElement(1, 0, m_below);
    grid->setColumnStretchFactor(1, cutShare);
    grid->setColumnStretchFactor(2, 1e-3);
    grid->setRowStretchFactor(1, cutShare);
    grid->setColumnSpacing(0);
    auto* sides = new QCPMarginGroup(m_plot);
    auto* ends = new QCPMarginGroup(m_plot);
    for (QCPAxisRect* rect : {m_rect, m_below}) rect->setMarginGroup(QCP::msLeft | QCP::msRight, sides);
    for (QCPLayoutElement* element : std::initializer_list<QCPLayoutElement*>{m_rect, m_beside, m_bar})
        element->setMarginGroup(QCP::msTop | QCP::msBottom, ends);
    for (QCPAxisRect* rect : {m_rect, m_below, m_beside}) {
        rect->setMinimumMargins(QMargins(4, 10, 12, 4));
        for (const auto side : {QCPAxis::atTop, QCPAxis::atRight}) rect->axis(side)->setTicks(false);
    }
    m_below->setMinimumMargins(QMargins(4, 4, 12, 4));
    x()->setTickLabels(false);  // the cut below has them
    m_beside->axis(QCPAxis::atLeft)->setTickLabels(false);
    m_beside->axis(QCPAxis::atBottom)->ticker()->setTickCount(3);
    m_below->axis(QCPAxis::atLeft)->ticker()->setTickCount(3);
}

void MapPlot::addCuts() {
    m_alongX = addCurve(m_below->axis(QCPAxis::atBottom), m_below->axis(QCPAxis::atLeft));
    m_alongX->setAdaptiveSampling(true);
    m_alongY = new QCPCurve(m_beside->axis(QCPAxis::atBottom), m_beside->axis(QCPAxis::atLeft));
}

// The cuts go along with the map.
void MapPlot::linkAxes() {
    using Changed = void (QCPAxis::*)(const QCPRange&);
    constexpr auto changed = static_cast<Changed>(&QCPAxis::rangeChanged);
    const auto link = [&](QCPAxis* a, QCPAxis* b) {
        connect(a, changed, b, [b](const QCPRange& range) { b->setRange(range); });
        connect(b, changed, a, [a](const QCPRange& range) { a->setRange(range); });
        connect(a, &QCPAxis::scaleTypeChanged, b, [b](QCPAxis::ScaleType type) { b->setScaleType(type); });
    };
    link(x(), m_below->axis(QCPAxis::atBottom));
    link(y(), m_beside->axis(QCPAxis::atLeft));
}

void MapPlot::present(const MapPicture& picture) {
    const bool isOther = !m_picture || !haveSameAxes(*m_picture, picture);
    const bool hasOtherPresets = isOther || m_picture->presets != picture.presets;
    m_picture = picture;
    if (!m_crosshair->place()) m_crosshair->setPlace(picture.placeOf(picture.report->study.base));
    m_bar->setVisible(true);
    m_view->setEmpty(false);
    m_raster->present(&picture);
    if (isOther) {
        const MapStudy& study = picture.report->study;
        m_view->adjust([&] {
            for (QCPAxisRect* rect : {m_rect, m_below}) setKind(rect->axis(QCPAxis::atBottom), study.x.kind);
            for (QCPAxisRect* rect : {m_rect, m_beside}) setKind(rect->axis(QCPAxis::atLeft), study.y.kind);
        });
    }
    if (hasOtherPresets) m_presets->present(m_picture, m_style);
    setLabels();
    m_contours->present(m_picture, m_style);
    showCuts();
    m_summary = summary();
    finish(isOther);
}

void MapPlot::clear() {
    m_picture.reset();
    m_view->setEmpty(true);
    m_raster->present(nullptr);
    m_bar->setVisible(false);
    m_alongX->data()->clear();
    m_alongY->data()->clear();
    for (QCPAxisRect* rect : {m_below, m_beside}) rect->axis(QCPAxis::atTop)->setLabel({});
    m_contours->present(m_picture, m_style);
    m_presets->present(m_picture, m_style);
    m_crosshair->setPlace({});
}

void MapPlot::setLabels() {
    const MapPicture& picture = *m_picture;
    const double factor = picture.output.factor;
    const QCPRange values(picture.colours.least * factor, picture.colours.largest * factor);
    y()->setLabel(picture.yLabel());
    m_below->axis(QCPAxis::atBottom)->setLabel(picture.xLabel());
    m_below->axis(QCPAxis::atLeft)->setLabel(picture.outputLabel());
    m_beside->axis(QCPAxis::atBottom)->setLabel(picture.outputLabel());
    m_bar->setLabel(picture.outputLabel());
    m_bar->setGradient(picture.colours.gradient());
    m_bar->setDataRange(values);
    const double room = 0.05 * values.size();
    m_below->axis(QCPAxis::atLeft)->setRange(values.lower - room, values.upper + room);
    m_beside->axis(QCPAxis::atBottom)->setRange(values.lower - room, values.upper + room);
}

// Through the row and the column of points nearest to the crosshair.
void MapPlot::showCuts() {
    if (!m_picture) return;
    const MapGrid& grid = m_picture->grid();
    m_cut = MapGrid::Place{grid.columns() / 2, grid.rows() / 2};
    if (const auto& here = m_crosshair->place())
        if (const auto found = pointAt(*here)) m_cut = found;
    const double factor = m_picture->output.factor;
    QVector<QCPGraphData> alongX;
    for (std::size_t column = 0; column < grid.columns(); ++column)
        if (grid.isThere(column, m_cut->row))
            alongX.append({grid.xs()[column] * m_picture->x.factor, grid.value(column, m_cut->row) * factor});
    QVector<QCPCurveData> alongY;
    for (std::size_t row = 0; row < grid.rows(); ++row)
        if (grid.isThere(m_cut->column, row))
            alongY.append(
                {double(row), grid.value(m_cut->column, row) * factor, grid.ys()[row] * m_picture->y.factor});
    m_alongX->data()->set(alongX);
    m_alongY->data()->set(alongY, true);
    nameCuts();
}

// Points of the map are rarely where the scenario is: their values must not pass for those of it.
bool MapPlot::nameCuts() {
    const MapGrid& grid = m_picture->grid();
    const QLocale locale = m_plot->locale();
    QString atY = m_picture->yText(grid.ys()[m_cut->row], locale);
    QString atX = m_picture->xText(grid.xs()[m_cut->column], locale);
    if (const auto& here = m_crosshair->place()) {
        if (m_picture->yText(here->y() / m_picture->y.factor, locale) != atY)
            atY = tr("computed at %1").arg(atY);
        if (m_picture->xText(here->x() / m_picture->x.factor, locale) != atX)
            atX = tr("computed at %1").arg(atX);
    }
    QCPAxis* below = m_below->axis(QCPAxis::atTop);
    QCPAxis* beside = m_beside->axis(QCPAxis::atTop);
    if (below->label() == atY && beside->label() == atX) return false;
    m_alongX->setName(atY);
    below->setLabel(atY);
    beside->setLabel(atX);
    return true;
}

void MapPlot::setCrosshair(const std::optional<QPointF>& place) {
    m_crosshair->setPlace(place);
    if (!m_picture || !place) return;
    const bool isOtherCut = pointAt(*place) != m_cut;
    if (isOtherCut) showCuts();
    if ((nameCuts() || isOtherCut) && m_plot->isVisible()) m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void MapPlot::restyle() {
    QCPAxisRect* bar = m_bar->axis()->axisRect();
    m_style.applyTo(*bar);
    for (QCPAxis* axis : m_rect->axes()) axis->grid()->setVisible(false);
    for (QCPAxis* axis : m_rect->axes() + bar->axes()) {
        // Outside: inside they would be lost in the colours.
        axis->setTickLength(0, axis->tickLabels() ? 4 : 0);
        axis->setSubTickLength(0, axis->tickLabels() ? 2 : 0);
    }
    m_alongX->setPen(m_style.linePen(0));
    m_alongY->setPen(m_style.linePen(0));
    m_raster->setStyle(m_style);
    m_crosshair->setStyle(m_style);
    m_contours->present(m_picture, m_style);
    m_presets->present(m_picture, m_style);
    if (!m_picture) return;
    showCuts();  // files have another locale
    m_summary = summary();
}

void MapPlot::setRanges() {
    if (!m_picture) return;
    const MapStudy& study = m_picture->report->study;
    x()->setRange(rangeOf(study.x, m_picture->x.factor));
    y()->setRange(rangeOf(study.y, m_picture->y.factor));
}

std::optional<MapGrid::Place> MapPlot::pointAt(QPointF shown) const {
    return m_picture ? m_picture->pointAt(shown) : std::nullopt;
}

QString MapPlot::readout(QPointF pixel) const {
    if (!m_picture || !m_rect->rect().contains(pixel.toPoint())) return {};
    const auto place = pointAt({x()->pixelToCoord(pixel.x()), y()->pixelToCoord(pixel.y())});
    return place ? m_picture->textAt(*place, m_plot->locale()) : QString();
}

KeyPlaces MapPlot::keyPlaces() const {
    KeyPlaces places;
    places.rect = m_rect;
    places.on = KeyPlaces::On::area;
    places.start = [this] { return m_crosshair->place(); };
    places.marks = [this] {
        QVector<QPointF> marks;
        if (!m_picture) return marks;
        for (const PresetPoint& preset : m_picture->presets)
            marks.append({preset.x * m_picture->x.factor, preset.y * m_picture->y.factor});
        return marks;
    };
    // Wraps the words as narrowly as possible: they are next to the point.
    places.words = [this](QPointF place) {
        return readout(pixelOf(place)).replace(QStringLiteral(" · "), QStringLiteral("\n"));
    };
    return places;
}

QString MapPlot::summary() const {
    const QLocale locale = m_plot->locale();
    const MapGrid& grid = m_picture->grid();
    const auto& extent = grid.extent();
    if (!extent) return grid.failed() > 0 ? tr("No point could be solved.") : tr("The map follows.");
    const ShownUnit& unit = m_picture->output;
    QString largest = numberText(extent->largest * unit.factor, 5, locale);
    if (!unit.unit.isEmpty()) largest += QChar(QChar::Nbsp) + unit.unit;
    QString text = tr("%1 is between %2 and %3")
                       .arg(outputName(*m_picture->report->study.output.output),
                            numberText(extent->least * unit.factor, 5, locale), largest);
    for (const Contour& contour : m_picture->report->contours)
        if (contour.lines.empty())
            text += tr(" · nowhere %1").arg(numberText(contour.level * m_picture->output.factor, 4, locale));
    if (const auto failed = grid.failed(); failed > 0)
        text += tr(" · %1 of %2 points not solved (hatched)").arg(failed).arg(grid.size());
    return text;
}

QString MapPlot::answer() const {
    if (!m_picture || !m_picture->grid().isComplete()) return {};
    const MapReport& report = *m_picture->report;
    const Output& output = *report.study.output.output;
    const auto rank = [&](const Contour& contour) {
        return std::pair(contour.level == decisiveLevel(output), contour.level);
    };
    const Contour* deciding = nullptr;
    for (const Contour& contour : report.contours)
        if (!contour.lines.empty() && (!deciding || rank(contour) > rank(*deciding))) deciding = &contour;
    const std::optional<ContourExtent> extent = deciding ? extentOf(*deciding) : std::nullopt;
    if (!extent) return {};
    const QLocale locale = m_plot->locale();
    const ShownUnit& unit = m_picture->output;
    QString level = numberText(deciding->level * unit.factor, 4, locale);
    if (!unit.unit.isEmpty()) level += QChar(QChar::Nbsp) + unit.unit;
    const auto x = [&](const ContourPoint& point) { return m_picture->xText(point.x, locale); };
    const auto y = [&](const ContourPoint& point) {
        return quantityText(point.y, m_picture->y, locale).trimmed();
    };
    const QString name = outputName(output), along = parameterName(*report.study.y.parameter);
    switch (sideOf(m_picture->grid(), deciding->level)) {
        case LevelSide::above:
            return tr("%1 exceeds %2 only where %3 is above %4. This lowest value is at %5.")
                .arg(name, level, along, y(extent->lowest), x(extent->lowest));
        case LevelSide::below:
            return tr("%1 exceeds %2 only where %3 is below %4. This highest value is at %5.")
                .arg(name, level, along, y(extent->highest), x(extent->highest));
        case LevelSide::mixed:
            break;
    }
    return tr("The line %1 = %2 runs from %3 = %4, at %5, up to %6, at %7.")
        .arg(name, level, along, y(extent->lowest), x(extent->lowest), y(extent->highest),
             x(extent->highest));
}

}  // namespace drillwave
