// SPDX-License-Identifier: GPL-3.0-or-later
// The answer of an identification beside its plots: values with their intervals, and what limits them.
#pragma once

#include <QScrollArea>
#include <string>
#include <vector>

#include "core/report/identify_report.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace drillwave {

class IdentifyPanel : public QScrollArea {
    Q_OBJECT

  public:
    explicit IdentifyPanel(QWidget* parent = nullptr);

    /// Shows the answer of a record that is not refused, and the next blow of several; a rejected one greyed
    /// and without intervals.
    void present(const IdentifyReport& report, const RecordAnswer& answer, const ReadingStyle& style);
    void clear();

  signals:
    /// The user wants the rock in the scenario, or a run with it pinned.
    void useWanted();
    void pinWanted();
    /// The user wants Design with the draws of the answer.
    void designWanted();
    /// The user wants to type a tolerance, by its key of --known.
    void toleranceWanted(const QString& key);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void showValues(const IdentifyReport& report, const RecordAnswer& answer, const ReadingStyle& style);
    void showLimits(const IdentifyReport& report, const RecordAnswer& answer, const ReadingStyle& style);
    void showRemarks(const IdentifyReport& report, const RecordAnswer& answer, const ReadingStyle& style);

    QTableWidget* m_values;
    QLabel* m_limitsTitle;
    QTableWidget* m_limits;
    QLabel* m_next;
    QLabel* m_remarks;
    QPushButton* m_use;
    QPushButton* m_pin;
    QPushButton* m_design;
    std::vector<std::string> m_keys;  // of --known, of the rows of m_limits
};

}  // namespace drillwave
