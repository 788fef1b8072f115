// SPDX-License-Identifier: GPL-3.0-or-later
// A table of the statistics of many blows, with their errors.
#pragma once

#include <QTableWidget>
#include <vector>

#include "core/study/drilling/drilling_study.h"

namespace drillwave {

class UnitChoice;

/// Table with the statistics of a blow sequence, such as mean, error and median. Each row is one quantity of
/// the blows. The table is high enough to show all rows.
class DrillingTable : public QTableWidget {
    Q_OBJECT

  public:
    explicit DrillingTable(QWidget* parent = nullptr);

    /// Shows the statistics of a blow sequence. Requires a result that has statistics.
    void present(const DrillingResult& result, const UnitChoice& units);
    void clearNumbers();
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  private:
    void setText(int row, int column, const QString& text);

    const std::vector<std::size_t> m_rows;  ///< indices in blowQuantities
};

}  // namespace drillwave
