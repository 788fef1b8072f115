// SPDX-License-Identifier: GPL-3.0-or-later
// Fields for the format of a table of samples and its columns; they are detected and can be changed.
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

    /// Sets the first lines of the imported file, and detects its format and columns again.
    void setLines(std::vector<std::string> lines);
    const std::vector<std::string>& lines() const { return m_lines; }

    /// Sets the fields to the values in `settings` as if the user had chosen them. Unknown columns are
    /// ignored.
    void use(const SignalOptions& settings);
    /// Adds the columns and the format that the user has chosen to `settings`, but not those that were only
    /// detected.
    void addTo(SignalOptions& settings) const;

    SampleSource source() const;
    /// Returns the unit that the table's header states for the column of values; nothing if it states none.
    std::optional<NamedSignalUnit> valueUnit() const;
    /// Returns the kind of signal (force, strain, voltage, …) that the column of values probably contains, if
    /// the table does not state its unit.
    SignalKind valueKind() const;
    /// Proposes a sample rate [Hz] estimated from the record, unless the table or the user gives one.
    void proposeRate(double rate);
    /// Returns the reason why the chosen format and columns are incomplete or wrong; empty if source()
    /// returns usable settings.
    QString problem() const;

  signals:
    /// Emitted when the settings that source() returns have changed.
    void changed();
    /// Emitted before changed() when another column of values is chosen, or its unit in the header has
    /// changed.
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
    QSet<const QWidget*> m_touched;  // columns and units that the user has set
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
