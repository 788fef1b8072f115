// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/identify/gauge_fields.h"

#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/signal/detected_table.h"
#include "core/text/units.h"
#include "ui/form/choice_box.h"
#include "ui/form/quantity_field.h"
#include "ui/pages/study/flow_layout.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

/// The column in words of --gauge: its name, or its number where the name says too little.
QString columnWord(const std::vector<TableColumn>& columns, std::size_t index) {
    const std::string& name = columns[index].name;
    const bool isPlain = !name.empty() && name.find_first_of("@+") == std::string::npos;
    if (isPlain && columnNamed(columns, name) == index) return fromView(name);
    return QString::number(index + 1);
}

bool isOfTime(const TableColumn& column) {
    return column.isStamp || column.isIndex || isTimeName(column.name) ||
           findUnit(Quantity::time, column.unit) != nullptr;
}

QString chosenColumn(const ChoiceBox& box) {
    return box.currentData().toString();
}

}  // namespace

GaugeFields::GaugeFields(QWidget* parent) : QWidget(parent) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        m_rows[i] = addRow(static_cast<int>(i) + 1);
        layout->addWidget(m_rows[i].box);
    }
    showRows();
}

GaugeFields::Row GaugeFields::addRow(int number) {
    Row row;
    row.box = new QWidget(this);
    auto* layout = new FlowLayout(row.box);
    const QString gauge = number == 1 ? tr("gauge") : tr("second gauge");
    const auto choice = [&](const char* name, const QString& title, const QString& tip) {
        auto* box = new ChoiceBox(row.box);
        box->setObjectName(QLatin1String(name) + QString::number(number));
        box->setAccessibleName(title);
        box->setToolTip(tip);
        box->followText();
        box->setMinimumContentsLength(4);
        connect(box, &QComboBox::currentIndexChanged, this, [this] {
            showRows();
            emit changed();
        });
        return box;
    };
    auto* label = new QLabel(gauge, row.box);
    row.column =
        choice("column", gauge,
               number == 1 ? tr("Column of the gauge that is nearest to the bit")
                           : tr("Column of another gauge along the same section, at least 0.5 m away"));
    label->setBuddy(row.column);
    row.opposite =
        choice("opposite", tr("%1, opposite side").arg(gauge),
               tr("Column of the gauge on the opposite side: the mean of both is free of bending"));
    row.distance = new QuantityField(Quantity::length, *findUnit(Quantity::length, "m"), row.box);
    row.distance->setObjectName(QStringLiteral("distance%1").arg(number));
    row.distance->setAccessibleName(tr("%1, distance from the bit face").arg(gauge));
    row.distance->setOptional(tr("from the bit"));
    row.distance->setHelp(tr("Distance of the gauge from the bit face"), row.distance->accessibleName());
    row.distance->setTaker([this](double value) {
        if (!(value > 0)) return tr("must be positive");
        emit changed();
        return QString();
    });
    connect(row.distance, &QuantityField::cleared, this, &GaugeFields::changed);
    row.place = new QLabel(row.box);
    row.place->setObjectName(QStringLiteral("place%1").arg(number));
    layout->addWidget(label);
    layout->addWidget(row.column);
    layout->addWidget(row.opposite);
    layout->addWidget(row.distance);
    if (QToolButton* unit = row.distance->unitButton()) {
        unit->setAccessibleName(tr("%1, unit").arg(row.distance->accessibleName()));
        layout->addWidget(unit);
    }
    layout->addWidget(row.place);
    return row;
}

void GaugeFields::fill(ChoiceBox& box, const QString& none, const QString& proposed) {
    const QSignalBlocker quiet(&box);
    const QString before = box.count() > 0 ? chosenColumn(box) : proposed;
    box.clear();
    if (!none.isEmpty()) box.addItem(none, QString());
    for (const QString& column : m_columns) box.addItem(column, column);
    const int kept = box.findData(before);
    box.setCurrentIndex(std::max(0, kept >= 0 ? kept : box.findData(proposed)));
}

void GaugeFields::setColumns(const std::vector<TableColumn>& columns) {
    m_columns.clear();
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (columns[i].isNumeric && !isOfTime(columns[i])) m_columns.push_back(columnWord(columns, i));
    fill(*m_rows[0].column, {}, m_columns.empty() ? QString() : m_columns.front());
    fill(*m_rows[1].column, tr("none"), {});
    for (Row& row : m_rows) fill(*row.opposite, tr("one side only"), {});
    showRows();
    emit changed();
}

void GaugeFields::present(const Scenario& scenario) {
    m_scenario = scenario;
    showRows();
}

void GaugeFields::showRows() {
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const Row& row = m_rows[i];
        row.box->setVisible(!m_columns.empty());
        const bool isChosen = !chosenColumn(*row.column).isEmpty();
        row.opposite->setVisible(isChosen);
        row.distance->setVisible(isChosen);
        if (QToolButton* unit = row.distance->unitButton()) unit->setVisible(isChosen);
        row.place->setVisible(isChosen);
        if (!isChosen || !hasUnits(m_scenario)) continue;
        const double distance = row.distance->value().value_or(0);
        const std::optional<GaugePlace> place =
            distance > 0 ? gaugePlace(m_scenario, distance) : std::nullopt;
        row.place->setText(
            !(distance > 0) ? QString()
            : place         ? tr("on %1, x = %2 m")
                          .arg(coreText(place->section.name), numberText(place->fromStruckEnd, 4, QLocale()))
                    : tr("not on a uniform section"));
    }
}

std::vector<GaugeChoice> GaugeFields::gauges() const {
    std::vector<GaugeChoice> gauges;
    for (const Row& row : m_rows) {
        const QString column = chosenColumn(*row.column);
        if (column.isEmpty()) continue;
        gauges.push_back({column.toStdString(), chosenColumn(*row.opposite).toStdString(),
                          row.distance->value().value_or(0)});
    }
    return gauges;
}

void GaugeFields::setDistances(const std::vector<double>& distances) {
    std::size_t next = 0;
    for (const Row& row : m_rows)
        if (!chosenColumn(*row.column).isEmpty() && next < distances.size())
            row.distance->setValue(distances[next++]);
    showRows();
}

}  // namespace drillwave
