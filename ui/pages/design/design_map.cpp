// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/design/design_map.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/report/design_words.h"
#include "ui/plot/axis_view.h"

namespace drillwave {
namespace {

bool isRange(const SweepAxis& axis) {
    return axis.kind == SweepAxis::Kind::linear || axis.kind == SweepAxis::Kind::logarithmic;
}

bool isLogarithmic(const SweepAxis& axis) {
    return axis.kind == SweepAxis::Kind::logarithmic;
}

std::vector<double> valuesOf(const SweepAxis& axis) {
    std::vector<double> values;
    for (std::uint64_t i = 0; i < axis.count; ++i) values.push_back(axis.value(i));
    return values;
}

/// Half a step beyond both ends, where the cells of the ends reach to.
QCPRange rangeOf(const SweepAxis& axis, double factor) {
    const double steps = static_cast<double>(std::max<std::uint64_t>(axis.count, 2) - 1);
    QCPRange range(axis.start * factor, axis.stop * factor);
    range.normalize();
    if (isLogarithmic(axis)) {
        const double ratio = std::pow(range.upper / range.lower, 0.5 / steps);
        return {range.lower / ratio, range.upper * ratio};
    }
    const double room =
        range.size() > 0 ? range.size() / steps / 2 : std::max(std::abs(range.lower), 1.0) / 20;
    return {range.lower - room, range.upper + room};
}

}  // namespace

bool hasMap(const DesignStudy& study) {
    return study.choices.size() == 2 && isRange(study.choices[0]) && isRange(study.choices[1]) &&
           study.choices[0].count >= leastRowsOfMap && study.choices[1].count >= 2;
}

MapPicture designMap(const DesignReport& report, const DesignUnits& units, const AimedOutput& value) {
    MapReport map;
    map.study.base = report.study.base;
    map.study.x = report.study.choices[1];
    map.study.y = report.study.choices[0];
    map.study.output.output = value.output;
    map.grid = MapGrid(valuesOf(map.study.x), valuesOf(map.study.y));
    const DesignAim& aim = report.study.aims.front();
    for (std::uint64_t d = 0; d < report.findings.designs.size(); ++d) {
        const std::size_t column = d % map.study.x.count, row = d / map.study.x.count;
        const double number = aimedValue(report, aim, d).value;
        const Message& reason = report.findings.designs[d].reason;
        if (std::isfinite(number))
            map.grid.set(column, row, number * value.factor);
        else if (!reason.isEmpty())
            map.grid.fail(column, row, reason);
    }
    MapPicture picture;
    picture.x = units.of(*map.study.x.parameter);
    picture.y = units.of(*map.study.y.parameter);
    picture.output = value.unit;
    picture.output.factor = 1;
    picture.colours = coloursOf(map.grid, std::nullopt);
    picture.report = std::make_shared<const MapReport>(std::move(map));
    return picture;
}

QPointF placeOnMap(const MapPicture& map, std::uint64_t design) {
    const MapGrid& grid = map.grid();
    return {grid.xs()[design % grid.columns()] * map.x.factor,
            grid.ys()[design / grid.columns()] * map.y.factor};
}

DesignMap::DesignMap(QCustomPlot* plot, QCPAxisRect* rect)
    : m_plot(plot),
      m_rect(rect),
      m_raster(new MapRaster(plot, rect)),
      m_bar(new QCPColorScale(plot)),
      m_ends(new QCPMarginGroup(plot)) {
    constexpr int barPixels = 14;
    m_raster->setLayer(QStringLiteral("background"));
    m_bar->setType(QCPAxis::atRight);
    m_bar->setBarWidth(barPixels);
    m_bar->setRangeDrag(false);
    m_bar->setRangeZoom(false);
    m_bar->setVisible(false);
}

void DesignMap::present(const MapPicture* picture) {
    constexpr int row = 1, column = 1;
    QCPLayoutGrid* grid = m_plot->plotLayout();
    if (picture && !m_picture) {
        grid->addElement(row, column, m_bar);
        grid->setColumnStretchFactor(column, 1e-3);
    } else if (!picture && m_picture) {
        grid->take(m_bar);
        grid->simplify();
    }
    // Makes them as high as the map.
    for (QCPLayoutElement* element : std::initializer_list<QCPLayoutElement*>{m_rect, m_bar})
        element->setMarginGroup(QCP::msTop | QCP::msBottom, picture ? m_ends : nullptr);
    m_picture = picture;
    m_bar->setVisible(picture != nullptr);
    m_raster->present(picture);
    if (!picture) return;
    const MapStudy& study = picture->report->study;
    QCPAxis *x = m_rect->axis(QCPAxis::atBottom), *y = m_rect->axis(QCPAxis::atLeft);
    for (const auto& [axis, along, factor] :
         {std::tuple(x, &study.x, picture->x.factor), std::tuple(y, &study.y, picture->y.factor)}) {
        const auto scale = isLogarithmic(*along) ? QCPAxis::stLogarithmic : QCPAxis::stLinear;
        if (axis->scaleType() != scale) axis->setRange(rangeOf(*along, factor));
        setScale(*axis, scale);
    }
    m_bar->setGradient(picture->colours.gradient());
    m_bar->setDataRange({picture->colours.least, picture->colours.largest});
}

void DesignMap::setStyle(const PlotStyle& style) {
    m_raster->setStyle(style);
    QCPAxisRect* bar = m_bar->axis()->axisRect();
    style.applyTo(*bar);
    for (const auto side : {QCPAxis::atBottom, QCPAxis::atLeft})
        m_rect->axis(side)->grid()->setVisible(!isShown());  // it would hide colours, and be hidden by them
}

void DesignMap::setRanges() const {
    const MapStudy& study = m_picture->report->study;
    m_rect->axis(QCPAxis::atBottom)->setRange(rangeOf(study.x, m_picture->x.factor));
    m_rect->axis(QCPAxis::atLeft)->setRange(rangeOf(study.y, m_picture->y.factor));
}

std::optional<std::uint64_t> DesignMap::designAt(QPointF place) const {
    const auto point = m_picture->pointAt(place);
    return point ? std::optional(point->row * m_picture->grid().columns() + point->column) : std::nullopt;
}

}  // namespace drillwave
