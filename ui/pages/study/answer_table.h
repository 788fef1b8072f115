// SPDX-License-Identifier: GPL-3.0-or-later
// The table of a study's answer, below its figure.
#pragma once

#include <QTableWidget>

#include "core/report/study.h"

namespace drillwave {

/// Read-only table of numbers, with titles of columns and rows.
class AnswerTable : public QTableWidget {
    Q_OBJECT

  public:
    explicit AnswerTable(const QString& accessibleName, QWidget* parent = nullptr);

    void present(const StudyTable& table);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void stretch();
    int heightOf(int contents) const;
};

}  // namespace drillwave
