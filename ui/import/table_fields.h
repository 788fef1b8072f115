// SPDX-License-Identifier: GPL-3.0-or-later
// How a table of samples is written, and which of its columns are wanted: found out, and to be changed.
#pragma once

#include <QSet>
#include <QWidget>
#include <optional>
#include <string>
#include <vector>

#include "core/signal/detected_table.h"
#include "core/signal/samples.h"
#include "core/signal/signal_reading.h"
#include "core/signal/signal_unit.h"

class QFormLayout;
class QSpinBox;

namespace drillwave {

class ChoiceBox;
class QuantityField;

class TableFields : public QWidget {
    Q_OBJECT

  public:
    explicit TableFields(QWidget* parent = nullptr);

    /// Takes the first lines of a file and detects everything again.
    void setLines(std::vector<std::string> lines);
    const std::vector<std::string>& lines() const { return m_lines; }

    /// Takes what settings give, as if the user had chosen it; a column that is not there is left as it is.
    void use(const SignalOptions& settings);
    /// Sets what the user has chosen, and nothing else.
    void addTo(SignalOptions& settings) const;

    SampleSource source() const;
    /// Returns the unit in the header of the chosen column of values; nothing if it is not known.
    std::optional<NamedSignalUnit> valueUnit() const;
    /// Returns the likely kind of that column where its unit is not stated.
    SignalKind valueKind() const;
    /// A rate that follows from the record, where the table states none and the user has typed none.
    void proposeRate(double rate);
    /// Why the choices make no source; empty when they do.
    QString problem() const;

  signals:
    /// Another source.
    void changed();
    /// Another column of values, or another unit in its header, before changed().
    void valueColumnChanged();

  private:
    void addFormat();
    void addColumns();
    void wire();
    RowFormat format() const;
    void takeTable(DetectedTable table);
    void showColumns(bool keepsChoices);
    void showTimeUnit();
    std::optional<TableColumn> valueColumn() const;
    void showRows();

    std::vector<std::string> m_lines;
    QSet<const QWidget*> m_touched;  // columns and units that the user has chosen
    DetectedTable m_table;
    QFormLayout* m_form;
    ChoiceBox* m_separator = nullptr;
    ChoiceBox* m_decimal = nullptr;
    QSpinBox* m_firstLine = nullptr;
    ChoiceBox* m_time = nullptr;
    ChoiceBox* m_timeUnit = nullptr;
    QuantityField* m_rate = nullptr;
    ChoiceBox* m_value = nullptr;
    ChoiceBox* m_second = nullptr;
    ChoiceBox* m_wrongRows = nullptr;
};

}  // namespace drillwave
