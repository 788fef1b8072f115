// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of a proof as a table.
#pragma once

#include <QAbstractTableModel>
#include <QStringList>
#include <functional>
#include <memory>
#include <vector>

#include "core/study/proof/accuracy.h"
#include "core/study/proof/stability.h"
#include "core/study/proof/string_accuracy.h"

namespace drillwave {

/// Words for cells that are made when they are looked at: some thousand rows cost nothing.
class ProofTable : public QAbstractTableModel {
    Q_OBJECT

  public:
    using QAbstractTableModel::QAbstractTableModel;

    /// The columns of `drillwave accuracy`, in its order of rows.
    void present(std::shared_ptr<const Accuracy> accuracy);
    void present(std::shared_ptr<const StringAccuracy> accuracy);
    /// The cases, the worst first.
    void present(std::shared_ptr<const StabilityReport> report);
    void clear();
    /// The row of the study that a row of the table shows.
    std::size_t studyRow(int row) const { return m_order[static_cast<std::size_t>(row)]; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

  private:
    using Cell = std::function<QString(std::size_t row, int column)>;
    void take(const QStringList& titles, std::vector<std::size_t> order, Cell cell);

    QStringList m_titles;
    std::vector<std::size_t> m_order;  // rows of the study
    Cell m_cell;
};

}  // namespace drillwave
