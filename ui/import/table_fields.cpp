// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/table_fields.h"

#include <QSignalBlocker>
#include <algorithm>

#include "core/signal/samples.h"
#include "core/text/decimal_text.h"
#include "ui/import/import_rows.h"
#include "ui/text/typed_text.h"

namespace drillwave {
namespace {

constexpr int none = -1;

QString columnText(const TableColumn& column, std::size_t index) {
    const QString number = TableFields::tr("column %1").arg(index + 1);
    QString name = QString::fromStdString(column.name);
    if (!column.unit.empty()) name += QStringLiteral(" [%1]").arg(QString::fromStdString(column.unit));
    return name.isEmpty() ? number : QStringLiteral("%1: %2").arg(number, name.trimmed());
}

// Units by their place in the list of the core.
QList<RowChoice> timeUnits() {
    QList<RowChoice> units;
    for (const Unit& unit : unitsOf(Quantity::time))
        units.append({shownUnitName(unit.name), static_cast<int>(units.size())});
    return units;
}

int indexOfTimeUnit(double factor) {
    const auto units = unitsOf(Quantity::time);
    for (std::size_t i = 0; i < units.size(); ++i)
        if (units[i].factor() == factor) return static_cast<int>(i);
    return 0;
}

/// The place that is chosen, of a column or a unit; nothing for none.
std::optional<std::size_t> placeOf(const ChoiceBox& box) {
    const int column = chosenValue(box);
    return column == none ? std::nullopt : std::optional(static_cast<std::size_t>(column));
}

}  // namespace

TableFields::TableFields(QWidget* parent) : QWidget(parent), m_form(new QFormLayout(this)) {
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setVerticalSpacing(3);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    addFormat();
    addColumns();
    wire();
    showRows();
}

void TableFields::addFormat() {
    m_separator = addChoice(*m_form, {"separator", tr("separator"), tr("Character between the cells")},
                            {{tr("tab"), '\t'},
                             {tr("semicolon ;"), ';'},
                             {tr("comma ,"), ','},
                             {tr("bar |"), '|'},
                             {tr("blanks"), ' '}});
    m_decimal = addChoice(*m_form, {"decimal", tr("decimal sign"), tr("Decimal sign of the numbers")},
                          {{tr("point 1.5"), static_cast<int>(DecimalSign::point)},
                           {tr("comma 1,5"), static_cast<int>(DecimalSign::comma)}});
    m_firstLine =
        addCount(*m_form, {"firstLine", tr("samples from line"), tr("First line with a sample")}, 1, 1, 1);
}

void TableFields::addColumns() {
    m_time = addChoice(*m_form, {"timeColumn", tr("time"), tr("The column of times, or none")}, {});
    m_timeUnit = addChoice(*m_form, {"timeUnit", tr("unit of time"), tr("Unit of the times")}, timeUnits());
    m_rate = addQuantity(*m_form, {"rate", tr("sampling rate"), tr("Samples per second")},
                         Quantity::frequency, "kHz", FieldRange::positive, {}, [this] {
                             m_touched.insert(m_rate);
                             emit changed();
                         });
    m_rate->setOptional(tr("not stated"));
    m_value = addChoice(*m_form, {"valueColumn", tr("signal"), tr("The column of the signal")}, {});
    m_second = addChoice(*m_form,
                         {"secondGauge", tr("mean with"),
                          tr("A second gauge on the other side of the bar: the mean is free of bending")},
                         {});
    m_wrongRows = addChoice(*m_form,
                            {"wrongRows", tr("rows without number"),
                             tr("Empty cells, NaN and words: refuse the file, or skip and count the rows")},
                            {{tr("refuse"), static_cast<int>(WrongRows::refused)},
                             {tr("skip and count"), static_cast<int>(WrongRows::skipped)}});
}

void TableFields::wire() {
    for (ChoiceBox* box : {m_separator, m_decimal})
        connect(box, &QComboBox::currentIndexChanged, this, [this, box] {
            m_touched.insert(box);
            takeTable(detectTable(m_lines, format()));
        });
    connect(m_firstLine, &QSpinBox::valueChanged, this, [this](int line) {
        m_touched.insert(m_firstLine);
        takeTable(tableFrom(m_lines, format(), static_cast<std::size_t>(line)));
    });
    for (ChoiceBox* box : {m_time, m_timeUnit, m_value, m_second})
        connect(box, &QComboBox::currentIndexChanged, this, [this, box] { m_touched.insert(box); });
    connect(m_time, &QComboBox::currentIndexChanged, this, [this] {
        m_touched.remove(m_timeUnit);
        showTimeUnit();
        showRows();
        emit changed();
    });
    connect(m_value, &QComboBox::currentIndexChanged, this, [this] {
        emit valueColumnChanged();
        emit changed();
    });
    for (ChoiceBox* box : {m_timeUnit, m_second, m_wrongRows})
        connect(box, &QComboBox::currentIndexChanged, this, &TableFields::changed);
}

RowFormat TableFields::format() const {
    // Who has chosen the decimal sign knows it: the other sign parts groups.
    return {static_cast<char>(chosenValue(*m_separator)), static_cast<DecimalSign>(chosenValue(*m_decimal)),
            m_table.format.otherSignGroups || m_touched.contains(m_decimal)};
}

void TableFields::setLines(std::vector<std::string> lines) {
    m_touched.clear();
    m_lines = std::move(lines);
    m_table = {};
    {
        const QSignalBlocker quiet(m_firstLine);
        m_firstLine->setMaximum(std::max(1, static_cast<int>(m_lines.size())));
    }
    takeTable(detectTable(m_lines));
}

std::optional<TableColumn> TableFields::valueColumn() const {
    const std::size_t column = placeOf(*m_value).value_or(0);
    return column < m_table.columns.size() ? std::optional(m_table.columns[column]) : std::nullopt;
}

// Choices of the user stay while the columns do, and names where no others are found.
void TableFields::takeTable(DetectedTable table) {
    const bool sameColumns = table.columns.size() == m_table.columns.size() && table.hasSamples();
    const auto isNameless = [](const TableColumn& column) {
        return column.name.empty() && column.unit.empty();
    };
    if (sameColumns && std::ranges::all_of(table.columns, isNameless))
        for (std::size_t i = 0; i < table.columns.size(); ++i) {
            table.columns[i].name = m_table.columns[i].name;
            table.columns[i].unit = m_table.columns[i].unit;
        }
    const std::optional<TableColumn> before = valueColumn();
    const int columnBefore = chosenValue(*m_value);
    m_table = std::move(table);
    choose(*m_separator, m_table.format.separator);
    choose(*m_decimal, static_cast<int>(m_table.format.decimal));
    {
        const QSignalBlocker quiet(m_firstLine);
        m_firstLine->setValue(static_cast<int>(m_table.firstLine));
    }
    showColumns(sameColumns);
    const std::optional<TableColumn> now = valueColumn();
    const bool sameSignal = before && now && columnBefore == chosenValue(*m_value) &&
                            before->name == now->name && before->unit == now->unit;
    if (!sameSignal) emit valueColumnChanged();
    emit changed();
}

void TableFields::showColumns(bool keepsChoices) {
    if (!keepsChoices)
        for (const QWidget* box : QList<const QWidget*>{m_time, m_timeUnit, m_value, m_second})
            m_touched.remove(box);
    QList<RowChoice> columns;
    for (std::size_t i = 0; i < m_table.columns.size(); ++i)
        columns.append({columnText(m_table.columns[i], i), static_cast<int>(i)});
    setEntries(*m_value, columns);
    setEntries(*m_second, QList<RowChoice>{{tr("no other gauge"), none}} + columns);
    setEntries(*m_time, columns + QList<RowChoice>{{tr("evenly spaced"), none}});
    const SampleGuess guess = guessedSource(m_table);
    const auto propose = [this](ChoiceBox& box, int choice) {
        if (!m_touched.contains(&box)) choose(box, choice);
    };
    propose(*m_value, static_cast<int>(guess.source.valueColumn));
    propose(*m_second, none);
    propose(*m_time, guess.source.timeColumn ? static_cast<int>(*guess.source.timeColumn) : none);
    if (!m_touched.contains(m_rate)) m_rate->setValue(m_table.rate);
    if (!m_touched.contains(m_timeUnit)) showTimeUnit();
    showRows();
}

// One that is not known is to be chosen.
void TableFields::showTimeUnit() {
    const std::optional<std::size_t> column = placeOf(*m_time);
    const std::optional<double> unit = column && *column < m_table.columns.size()
                                           ? statedTimeUnit(m_table.columns[*column])
                                           : std::optional(1.0);
    setEntries(*m_timeUnit, unit ? timeUnits() : QList<RowChoice>{{tr("choose"), none}} + timeUnits());
    choose(*m_timeUnit, unit ? indexOfTimeUnit(*unit) : none);
}

void TableFields::showRows() {
    const bool evenly = chosenValue(*m_time) == none || m_time->count() == 0;
    const std::optional<std::size_t> column = placeOf(*m_time);
    const bool isStamp =
        !evenly && column && *column < m_table.columns.size() && m_table.columns[*column].isStamp;
    setRowVisible(*m_form, *m_timeUnit, !evenly && !isStamp);
    setRowVisible(*m_form, *m_rate, evenly);
    const bool hasSecond = m_value->count() - (evenly ? 0 : 1) > 1;
    if (!hasSecond) choose(*m_second, none);
    setRowVisible(*m_form, *m_second, hasSecond);
}

void TableFields::use(const SignalOptions& settings) {
    const auto pick = [](ChoiceBox& box, int value) {
        if (const int index = box.findData(value); index >= 0) box.setCurrentIndex(index);
    };
    if (settings.separator) pick(*m_separator, *settings.separator);
    if (settings.decimal) pick(*m_decimal, static_cast<int>(*settings.decimal));
    if (settings.firstLine) m_firstLine->setValue(static_cast<int>(*settings.firstLine));
    const auto pickColumn = [&](ChoiceBox& box, const std::string& wanted) {
        const std::optional<std::size_t> column = columnNamed(m_table.columns, wanted);
        if (!column) return false;
        pick(box, static_cast<int>(*column));
        m_touched.insert(&box);
        return true;
    };
    if (settings.rate) {
        pick(*m_time, none);
        m_rate->setValue(settings.rate);
        m_touched.insert(m_rate);
    }
    if (!settings.timeColumn.empty()) pickColumn(*m_time, settings.timeColumn);
    const std::string& signal = settings.signalColumn;
    const std::size_t plus = signal.find('+');
    if (!signal.empty() && !pickColumn(*m_value, signal) && plus != std::string::npos) {
        pickColumn(*m_value, std::string(trimmed(signal.substr(0, plus))));
        pickColumn(*m_second, std::string(trimmed(signal.substr(plus + 1))));
    }
    if (settings.timeUnit) pick(*m_timeUnit, indexOfTimeUnit(*settings.timeUnit));
    pick(*m_wrongRows, static_cast<int>(settings.wrongRows));
    showRows();
    emit changed();
}

void TableFields::addTo(SignalOptions& settings) const {
    const SampleSource now = source();
    const auto nameOf = [this](std::size_t column) {
        const std::string& name = m_table.columns[column].name;
        return name.empty() ? std::to_string(column + 1) : name;
    };
    if (m_touched.contains(m_separator)) settings.separator = now.format.separator;
    if (m_touched.contains(m_decimal)) settings.decimal = now.format.decimal;
    if (m_touched.contains(m_firstLine)) settings.firstLine = now.firstLine;
    if (m_touched.contains(m_time) && now.timeColumn) settings.timeColumn = nameOf(*now.timeColumn);
    if (m_touched.contains(m_value) || now.secondGauge) {
        settings.signalColumn = nameOf(now.valueColumn);
        if (now.secondGauge) settings.signalColumn += "+" + nameOf(*now.secondGauge);
    }
    if (m_touched.contains(m_timeUnit) && now.timeColumn) settings.timeUnit = now.timeUnit;
    if (m_touched.contains(m_rate) && !now.timeColumn) settings.rate = m_rate->value();
    settings.wrongRows = now.wrongRows;
}

SampleSource TableFields::source() const {
    SampleSource source;
    source.format = format();
    source.firstLine = static_cast<std::size_t>(m_firstLine->value());
    source.timeColumn = placeOf(*m_time);
    const std::optional<std::size_t> unit = placeOf(*m_timeUnit);
    source.timeUnit = unit ? unitsOf(Quantity::time)[*unit].factor() : 1;
    source.interval = 1 / m_rate->value().value_or(1);
    source.valueColumn = placeOf(*m_value).value_or(0);
    source.secondGauge = placeOf(*m_second);
    source.wrongRows = static_cast<WrongRows>(chosenValue(*m_wrongRows));
    return source;
}

std::optional<NamedSignalUnit> TableFields::valueUnit() const {
    return statedUnit(valueColumn().value_or(TableColumn{}));
}

SignalKind TableFields::valueKind() const {
    return likelyKind(valueColumn().value_or(TableColumn{}));
}

void TableFields::proposeRate(double rate) {
    if (!m_touched.contains(m_rate) && !m_table.rate) m_rate->setValue(rate);
}

QString TableFields::problem() const {
    if (m_lines.empty()) return tr("The file is empty, or no text.");
    if (!m_table.hasSamples())
        return tr("No line of numbers is found in the first %1 lines with this separator and decimal sign: "
                  "choose others, or the first line with a sample. Remove a longer header from the file.")
            .arg(m_lines.size());
    if (m_table.hasRows)
        return tr(
            "Each channel of this table is a row: turn rows into columns in a spreadsheet, or read it by "
            "drillwave signal -o.");
    if (m_table.isDecimalOpen && !m_touched.contains(m_decimal))
        return tr("decimal sign: 1,234 and 1.234 can be a decimal number or a thousand: choose the sign.");
    const SampleSource now = source();
    if (now.timeColumn == now.valueColumn)
        return tr("Time and signal are the same column: choose another one, or a sampling rate.");
    if (now.secondGauge == now.valueColumn || (now.secondGauge && now.secondGauge == now.timeColumn))
        return tr("The second gauge is a column that is used already: choose another one.");
    if (now.timeColumn && chosenValue(*m_timeUnit) == none) {
        const QString unit = QString::fromStdString(m_table.columns[*now.timeColumn].unit);
        return unit.isEmpty() ? tr("unit of time: not given in the table: choose one.")
                              : tr("unit of time: %1 is not known: choose one.").arg(unit);
    }
    if (!now.timeColumn && !m_rate->problem().isEmpty())
        return tr("sampling rate: %1").arg(m_rate->problem());
    if (!now.timeColumn && !m_rate->value())
        return m_table.bareRate ? tr("sampling rate: the table gives “%1” without a unit: type the rate.")
                                      .arg(QString::fromStdString(m_table.rateText))
                                : tr("sampling rate: not given in the table: type it.");
    return {};
}

}  // namespace drillwave
