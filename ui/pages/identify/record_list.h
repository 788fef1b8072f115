// SPDX-License-Identifier: GPL-3.0-or-later
// The records of an identification in their order along the hole, each with its verdict.
#pragma once

#include <QTableWidget>
#include <vector>

namespace drillwave {

/// A row for each record. One row is on show.
class RecordList : public QTableWidget {
    Q_OBJECT

  public:
    struct Row {
        QString record, path, verdict, misfit;
        bool operator==(const Row&) const = default;
    };

    explicit RecordList(QWidget* parent = nullptr);

    /// Shows the rows and marks the one on show; −1 marks none.
    void present(std::vector<Row> rows, int shown);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  signals:
    /// The user wants to see a record, or to take its file out of the list.
    void chosen(int row);
    void removeWanted(const QString& path);

  private:
    int heightOf(int rows) const;
    void addRemoval(int row);

    std::vector<Row> m_rows;
};

}  // namespace drillwave
