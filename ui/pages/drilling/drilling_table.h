// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics of many blows, with their errors.
#pragma once

#include <QTableWidget>
#include <vector>

#include "core/study/drilling/drilling_study.h"

namespace drillwave {

class UnitChoice;

/// A row for each quantity of a blow, all of them in view.
class DrillingTable : public QTableWidget {
    Q_OBJECT

  public:
    explicit DrillingTable(QWidget* parent = nullptr);

    /// Requires statistics.
    void present(const DrillingResult& result, const UnitChoice& units);
    void clearNumbers();
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  private:
    void setText(int row, int column, const QString& text);

    const std::vector<std::size_t> m_rows;  ///< places in blowQuantities
};

}  // namespace drillwave
