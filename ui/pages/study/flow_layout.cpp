// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/study/flow_layout.h"

#include <algorithm>

namespace drillwave {

FlowLayout::FlowLayout(QWidget* parent) : QLayout(parent) {
    setContentsMargins(8, 6, 8, 0);
    setSpacing(6);
}

FlowLayout::~FlowLayout() = default;

void FlowLayout::addItem(QLayoutItem* item) {
    m_items.emplace_back(item);
}

QLayoutItem* FlowLayout::itemAt(int index) const {
    return index >= 0 && index < count() ? m_items[static_cast<std::size_t>(index)].get() : nullptr;
}

QLayoutItem* FlowLayout::takeAt(int index) {
    if (index < 0 || index >= count()) return nullptr;
    QLayoutItem* item = m_items[static_cast<std::size_t>(index)].release();
    m_items.erase(m_items.begin() + index);
    return item;
}

QSize FlowLayout::minimumSize() const {
    QSize least;
    for (const auto& item : m_items) least = least.expandedTo(item->minimumSize());
    const QMargins margins = contentsMargins();
    return least + QSize(margins.left() + margins.right(), margins.top() + margins.bottom());
}

QSize FlowLayout::sizeHint() const {
    const QMargins margins = contentsMargins();
    QSize line(-spacing(), 0);
    for (const auto& item : m_items) {
        if (item->isEmpty()) continue;
        const QSize size = item->sizeHint();
        line = {line.width() + spacing() + size.width(), std::max(line.height(), size.height())};
    }
    return line.expandedTo({0, 0}) +
           QSize(margins.left() + margins.right(), margins.top() + margins.bottom());
}

// Size of an item in a line of that width.
QSize FlowLayout::sizeIn(const QLayoutItem& item, int width) const {
    const QSize size = item.sizeHint();
    if (size.width() <= width) return size;
    return {width, item.hasHeightForWidth() ? item.heightForWidth(width) : size.height()};
}

void FlowLayout::setGeometry(const QRect& area) {
    QLayout::setGeometry(area);
    arrange(area, Moving::yes);
}

// Items of a line are centred on it. Returns the height that is needed.
int FlowLayout::arrange(const QRect& area, Moving moving) const {
    const QRect inside = area.marginsRemoved(contentsMargins());
    std::vector<std::pair<QLayoutItem*, int>> line;  // with their places
    int x = inside.left(), y = inside.top(), height = 0;
    const auto endLine = [&] {
        if (moving == Moving::yes)
            for (const auto& [item, left] : line) {
                const QSize size = sizeIn(*item, inside.width());
                item->setGeometry({{left, y + (height - size.height()) / 2}, size});
            }
        line.clear();
    };
    for (const auto& item : m_items) {
        if (item->isEmpty()) continue;
        const QSize size = sizeIn(*item, inside.width());
        if (!line.empty() && x + size.width() > inside.right() + 1) {
            endLine();
            y += height + spacing();
            x = inside.left();
            height = 0;
        }
        line.emplace_back(item.get(), x);
        x += size.width() + spacing();
        height = std::max(height, size.height());
    }
    endLine();
    return y + height + contentsMargins().bottom() - area.top();
}

}  // namespace drillwave
