// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/result/event_model.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "ui/text/number_text.h"

namespace drillwave {
namespace {

QString eventText(ContactEvent kind) {
    switch (kind) {
        case ContactEvent::contact:
            return EventModel::tr("contact");
        case ContactEvent::unloading:
            return EventModel::tr("unloading begins");
        case ContactEvent::primaryLoading:
            return EventModel::tr("primary loading");
        case ContactEvent::separation:
            return EventModel::tr("separation");
        case ContactEvent::corner:
            return EventModel::tr("corner of the law");
    }
    return {};
}

}  // namespace

void EventModel::present(const SolvedBlowPtr& blow) {
    beginResetModel();
    m_blow = blow;
    // One unit for all rows, in which the last can be read.
    const bool listed = rowCount() > 0;
    m_unit = listed ? readable(blow->units.time, timeAt(rowCount() - 1)) : blow->units.time;
    endResetModel();
}

double EventModel::timeAt(int row) const {
    return m_blow->impact.events[static_cast<std::size_t>(row)].time;
}

std::optional<int> EventModel::rowAt(double time) const {
    if (rowCount() == 0) return std::nullopt;
    const std::vector<ImpactEvent>& events = m_blow->impact.events;
    const double rounding = 1e-12 * (1 + std::abs(time));
    const auto found = std::ranges::lower_bound(events, time - rounding, {}, &ImpactEvent::time);
    if (found == events.end() || found->time > time + rounding) return std::nullopt;
    return static_cast<int>(found - events.begin());
}

int EventModel::rowCount(const QModelIndex& parent) const {
    if (parent.isValid() || !m_blow || !m_blow->fault.isEmpty()) return 0;
    return static_cast<int>(m_blow->impact.events.size());
}

int EventModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : 2;
}

QVariant EventModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    if (role == Qt::TextAlignmentRole && index.column() == 0) return int{Qt::AlignRight | Qt::AlignVCenter};
    if (role != Qt::DisplayRole) return {};
    const ImpactEvent& event = m_blow->impact.events[static_cast<std::size_t>(index.row())];
    if (index.column() == 1) return eventText(event.kind);
    return numberText(event.time * m_unit.factor, 5, QLocale());
}

QVariant EventModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    if (section == 1) return tr("event at the bit");
    return m_blow ? m_unit.axisLabel(QStringLiteral("t")) : QStringLiteral("t");
}

}  // namespace drillwave
