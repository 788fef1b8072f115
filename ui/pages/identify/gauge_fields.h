// SPDX-License-Identifier: GPL-3.0-or-later
// Choice of the columns of a record that hold gauge signals, and of the positions of the gauges on the rod or
// string.
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

/// Controls for one or two strain gauges on the rod: the column of the record with the signal, and the
/// position of the gauge.
class GaugeFields : public QWidget {
    Q_OBJECT

  public:
    explicit GaugeFields(QWidget* parent = nullptr);

    /// Offers the columns of a record. A chosen column is kept if the record has a column of the same name.
    void setColumns(const std::vector<TableColumn>& columns);
    /// Shows on which section of the scenario each gauge is.
    void present(const Scenario& scenario);
    /// Returns the chosen gauges with column and distance from the bit face [m]; 0 if no distance is entered.
    std::vector<GaugeChoice> gauges() const;
    /// Sets the distances from the bit face [m], in the order of gauges(). Emits no changed().
    void setDistances(const std::vector<double>& distances);

  signals:
    /// Reports that gauges() has changed.
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
    std::vector<QString> m_columns;  // columns of numbers, as the command names them
    Scenario m_scenario;
};

}  // namespace drillwave
