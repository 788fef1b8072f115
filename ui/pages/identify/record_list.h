// SPDX-License-Identifier: GPL-3.0-or-later
// The list of the records of an identification, in their order along the hole, each with its verdict.
#pragma once

#include <QTableWidget>
#include <vector>

namespace drillwave {

/// Table with a row for each record. The row of the record that is shown is marked.
class RecordList : public QTableWidget {
    Q_OBJECT

  public:
    /// Texts of one row: name of the record, path of its file, verdict and misfit.
    struct Row {
        QString record, path, verdict, misfit;
        bool operator==(const Row&) const = default;
    };

    explicit RecordList(QWidget* parent = nullptr);

    /// Shows the rows and marks row `shown` (from 0); −1 marks none.
    void present(std::vector<Row> rows, int shown);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  signals:
    /// Reports that the user wants to see the record in this row.
    void chosen(int row);
    /// Reports that the user wants to remove this file from the list.
    void removeWanted(const QString& path);

  private:
    int heightOf(int rows) const;
    void addRemoval(int row);

    std::vector<Row> m_rows;
};

}  // namespace drillwave
