// SPDX-License-Identifier: GPL-3.0-or-later
// Columns of a record that are gauges, and where these are on the rod or string.
#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "core/model/scenario.h"
#include "core/signal/signal_unit.h"
#include "core/study/identify/gauge_reading.h"

class QLabel;

namespace drillwave {

class ChoiceBox;
class QuantityField;
class UnitChoice;

/// A row for the gauge and one for a second gauge along the rod.
class GaugeFields : public QWidget {
    Q_OBJECT

  public:
    explicit GaugeFields(QWidget* parent = nullptr);

    /// The columns of another record; what was chosen stays where there are columns of that name.
    void setColumns(const std::vector<TableColumn>& columns);
    /// Names the sections that the gauges are on.
    void present(const Scenario& scenario);
    /// The gauges that are chosen; a distance that is not given is 0.
    std::vector<GaugeChoice> gauges() const;
    /// Sets distances from the bit face [m], those of gauges() in their order, and tells nobody.
    void setDistances(const std::vector<double>& distances);

  signals:
    /// gauges() are others.
    void changed();

  private:
    struct Row {
        QWidget* box = nullptr;
        ChoiceBox* column = nullptr;
        ChoiceBox* opposite = nullptr;
        QuantityField* distance = nullptr;
        QLabel* place = nullptr;
    };
    Row addRow(int number);
    void fill(ChoiceBox& box, const QString& none, const QString& proposed);
    void showRows();

    std::array<Row, 2> m_rows;
    std::vector<QString> m_columns;  // words of the command for columns of numbers
    Scenario m_scenario;
};

}  // namespace drillwave
