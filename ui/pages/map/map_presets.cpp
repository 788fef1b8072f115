// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/map/map_presets.h"

#include "ui/pages/map/map_raster.h"
#include "ui/text/shown_text.h"

namespace drillwave {

void MapPresets::present(const std::optional<MapPicture>& picture, const PlotStyle& style) {
    for (QCPAbstractItem* item : m_items) m_map->parentPlot()->removeItem(item);
    m_items.clear();
    if (!picture) return;
    bool above = false;  // names of neighbours are on different sides
    for (const PresetPoint& preset : picture->presets) {
        const auto column = AxisPlaces(picture->report->study.x).nearest(preset.x);
        const bool leftward = column && 4 * *column > 3 * picture->grid().columns();
        above = !above;
        add(preset, (leftward ? Qt::AlignRight : Qt::AlignLeft) | (above ? Qt::AlignBottom : Qt::AlignTop),
            *picture, style);
    }
}

void MapPresets::add(const PresetPoint& preset, Qt::Alignment side, const MapPicture& picture,
                     const PlotStyle& style) {
    QColor behind = style.background;
    behind.setAlpha(170);
    auto* mark = new QCPItemTracer(m_map->parentPlot());
    mark->setStyle(QCPItemTracer::tsSquare);
    mark->setSize(7);
    auto* text = new QCPItemText(m_map->parentPlot());
    text->setText(translated(preset.name));
    text->setPositionAlignment(side);
    text->setPadding(QMargins(6, 4, 6, 4));
    for (QCPItemPosition* position : {mark->position, text->position}) {
        position->setType(QCPItemPosition::ptPlotCoords);
        position->setAxes(m_map->axis(QCPAxis::atBottom), m_map->axis(QCPAxis::atLeft));
        position->setAxisRect(m_map);
        position->setCoords(preset.x * picture.x.factor, preset.y * picture.y.factor);
    }
    for (QCPAbstractItem* item : {static_cast<QCPAbstractItem*>(mark), static_cast<QCPAbstractItem*>(text)}) {
        item->setSelectable(false);
        item->setClipAxisRect(m_map);
        m_items.append(item);
    }
    mark->setPen(QPen(style.text, 1.5));
    mark->setBrush(style.background);
    text->setFont(style.font);
    text->setColor(style.text);
    text->setBrush(behind);
}

}  // namespace drillwave
