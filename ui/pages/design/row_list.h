// SPDX-License-Identifier: GPL-3.0-or-later
// A list of rows of controls that the user can add and remove.
#pragma once

#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <vector>

namespace drillwave {

/// List of rows of controls in a widget. The widget owns the rows, their layout and the button that adds a
/// row. A `Row` is a QWidget with a signal removed() and a function setRemovable().
template <class Row>
class RowList {
  public:
    /// Creates an empty list of `least` to `most` rows. New rows are inserted before the button `add`, or at
    /// the end if the button is in another layout.
    RowList(QVBoxLayout& layout, QToolButton& add, std::size_t least, std::size_t most)
        : m_layout(layout), m_add(add), m_least(least), m_most(most) {}

    const std::vector<Row*>& rows() const { return m_rows; }
    /// Returns whether the list has the largest number of rows.
    bool isFull() const { return m_rows.size() >= m_most; }

    /// Appends a row. Calls `whenRemoved` after the user has removed it by its button.
    template <class Told>
    void append(Row* row, Told whenRemoved) {
        m_layout.insertWidget(m_layout.indexOf(&m_add), row);
        m_rows.push_back(row);
        QObject::connect(row, &Row::removed, row, [this, row, whenRemoved] {
            remove(row);
            whenRemoved();
        });
        row->show();
        showButtons();
    }
    /// Removes the last row. Requires at least one row.
    void removeLast() { remove(m_rows.back()); }
    void clear() {
        while (!m_rows.empty()) remove(m_rows.back());
    }

  private:
    void remove(Row* row) {
        std::erase(m_rows, row);
        m_layout.removeWidget(row);
        row->hide();
        row->deleteLater();
        showButtons();
    }
    void showButtons() {
        m_add.setVisible(!isFull());
        for (Row* row : m_rows) row->setRemovable(m_rows.size() > m_least);
    }

    QVBoxLayout& m_layout;
    QToolButton& m_add;
    std::size_t m_least, m_most;
    std::vector<Row*> m_rows;
};

}  // namespace drillwave
