// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/result/event_table.h"

#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLocale>
#include <QScopedValueRollback>
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

constexpr int visibleEvents = 7;

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

EventTable::EventTable(QWidget* parent) : QTableView(parent), m_model(new EventModel(this)) {
    setAccessibleName(tr("Events at the bit"));
    setModel(m_model);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setShowGrid(false);
    setAlternatingRowColors(true);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    horizontalHeader()->setStretchLastSection(true);
    horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    horizontalHeader()->setResizeContentsPrecision(visibleEvents);  // not of thousands of rows
    setContextMenuPolicy(Qt::NoContextMenu);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setToolTip(tr("Select an event to move the time cursor there"));
    setTabKeyNavigation(false);
    const int header = horizontalHeader()->sizeHint().height();
    setMinimumHeight(header + visibleEvents * verticalHeader()->defaultSectionSize());
    connect(selectionModel(), &QItemSelectionModel::currentRowChanged, this, &EventTable::choose);
    // The row that is current already can be chosen again when the cursor has gone elsewhere.
    connect(this, &QTableView::clicked, this, &EventTable::choose);
    connect(this, &QTableView::activated, this, &EventTable::choose);
}

void EventTable::present(const SolvedBlowPtr& blow) {
    m_model->present(blow);
    markEvent();
}

void EventTable::setTime(std::optional<double> time) {
    m_time = time;
    markEvent();
}

// The keyboard comes by on its way: that makes a row the current one, and chooses no time.
void EventTable::focusInEvent(QFocusEvent* event) {
    const QScopedValueRollback following(m_following, true);
    QTableView::focusInEvent(event);
}

void EventTable::choose(const QModelIndex& index) {
    if (index.isValid() && !m_following) emit timeChosen(m_model->timeAt(index.row()));
}

void EventTable::markEvent() {
    const QScopedValueRollback following(m_following, true);
    const QModelIndex current = currentIndex();
    const bool isThere = m_time && current.isValid() && m_model->timeAt(current.row()) == *m_time;
    const std::optional<int> row = isThere ? current.row() : m_time ? m_model->rowAt(*m_time) : std::nullopt;
    if (!row) {
        clearSelection();
        return;
    }
    selectRow(*row);
}

}  // namespace drillwave
