// SPDX-License-Identifier: GPL-3.0-or-later
// The points of a tabulated pulse: a list that is never changed, so that copies of a scenario share it.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace drillwave {

/// One point of a tabulated pulse: time [s] and force [N]; any units in a dimensionless scenario.
struct TablePoint {
    double time = 0;
    double force = 0;
    bool operator==(const TablePoint&) const = default;
};

/// Behaves as a list of points by value; a copy costs a pointer, however many there are.
class TablePoints {
  public:
    TablePoints() = default;
    TablePoints(std::vector<TablePoint> points)
        : m_points(points.empty() ? nullptr
                                  : std::make_shared<const std::vector<TablePoint>>(std::move(points))) {}
    TablePoints(std::initializer_list<TablePoint> points) : TablePoints(std::vector<TablePoint>(points)) {}

    bool empty() const { return !m_points; }
    std::size_t size() const { return list().size(); }
    const TablePoint& operator[](std::size_t i) const { return list()[i]; }
    const TablePoint& front() const { return list().front(); }
    const TablePoint& back() const { return list().back(); }
    auto begin() const { return list().begin(); }
    auto end() const { return list().end(); }

    /// Whether both are the same piece of memory, not only the same points.
    bool isSharedWith(const TablePoints& other) const { return m_points == other.m_points; }

    friend bool operator==(const TablePoints& a, const TablePoints& b) {
        return a.isSharedWith(b) || a.list() == b.list();
    }

  private:
    const std::vector<TablePoint>& list() const {
        static const std::vector<TablePoint> none;
        return m_points ? *m_points : none;
    }

    std::shared_ptr<const std::vector<TablePoint>> m_points;  // nullptr where there are none
};

}  // namespace drillwave
