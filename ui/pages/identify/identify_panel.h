// SPDX-License-Identifier: GPL-3.0-or-later
// The answer of an identification beside its plots: values with their intervals, and the tolerances that
// limit them.
#pragma once

#include <QScrollArea>
#include <string>
#include <vector>

#include "core/report/identify_report.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace drillwave {

/// Panel with the identified values of the rock, and buttons to use them.
class IdentifyPanel : public QScrollArea {
    Q_OBJECT

  public:
    explicit IdentifyPanel(QWidget* parent = nullptr);

    /// Shows the rock identified from one record, and the most useful further measurement. Requires a record
    /// that was not refused. Values of a rejected fit are grey and have no intervals.
    void present(const IdentifyReport& report, const RecordAnswer& answer, const ReadingStyle& style);
    void clear();

  signals:
    /// Reports that the user wants to copy the identified rock into the scenario.
    void useWanted();
    /// Reports that the user wants to pin a run (a result kept for comparison) with the identified rock.
    void pinWanted();
    /// Reports that the user wants to use the identified rock as uncertain input of the page Design.
    void designWanted();
    /// Reports that the user wants to type a tolerance. `key` is its key in the option `--known`.
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
    QWidget* m_buttons;
    QPushButton* m_use;
    QPushButton* m_pin;
    QPushButton* m_design;
    std::vector<std::string> m_keys;  // keys of `--known` for the rows of m_limits
};

}  // namespace drillwave
