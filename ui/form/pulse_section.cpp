// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/pulse_section.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLocale>
#include <QSignalBlocker>

#include "core/model/parameter.h"
#include "core/model/scales.h"
#include "ui/form/parameter_row.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

QString tableText(const Scenario& scenario, const UnitChoice& units) {
    const QLocale locale;
    const auto count = static_cast<qlonglong>(scenario.pulse.tablePoints.size());
    const QString from =
        scenario.pulse.tableFile.empty()
            ? tr("kept in the scenario itself")
            : tr("from %1").arg(QFileInfo(QFile::decodeName(scenario.pulse.tableFile.c_str())).fileName());
    if (scenario.form == ScenarioForm::dimensionless)
        return tr("%1 points, scaled to t₀ and I₀, %2").arg(locale.toString(count), from);
    return tr("%1 points, %2, %3, %4")
        .arg(locale.toString(count), units.text(pulseDuration(scenario), UnitKind::time),
             units.text(pulseImpulse(scenario), UnitKind::impulse), from);
}

constexpr int mostPointsKept = 15'000;  // in a scenario itself, which may have 1 MiB

}  // namespace

PulseSection::PulseSection(Document& document, Questions& questions, QGridLayout* grid, QWidget* parent)
    : QObject(parent), m_document(document), m_questions(questions) {
    addShape(grid, parent);
    m_preview = new PulsePreview(document.units(), parent);
    grid->addWidget(m_preview, grid->rowCount(), 0, 1, formColumns);
    addTable(grid, parent);
    addImpulse(grid, parent);
}

void PulseSection::addShape(QGridLayout* grid, QWidget* parent) {
    auto* label = new QLabel(tr("shape"), parent);
    m_shape = new ChoiceBox(parent);
    m_shape->setObjectName(QStringLiteral("pulse.shape"));
    m_shape->setAccessibleName(tr("Hammer blow: shape"));
    m_shape->setToolTip(tr("Shape of the force of the hammer on the rod over time"));
    label->setBuddy(m_shape);
    const int row = grid->rowCount();
    grid->addWidget(label, row, 0);
    auto* measured = new QPushButton(tr("Measured…"), parent);
    measured->setObjectName(QStringLiteral("importBlow"));
    measured->setToolTip(
        tr("Import a measured hammer blow: any table of samples, as a force, a strain or the output of a "
           "bridge"));
    auto* shapes = new QHBoxLayout;
    shapes->addWidget(m_shape, 1);
    shapes->addWidget(measured);
    grid->addLayout(shapes, row, 1, 1, formColumns - 1);
    connect(measured, &QPushButton::clicked, this, &PulseSection::importRequested);
    connect(m_shape, &QComboBox::activated, this,
            [this](int index) { chooseShape(static_cast<PulseShape>(m_shape->itemData(index).toInt())); });
}

void PulseSection::addTable(QGridLayout* grid, QWidget* parent) {
    m_table = new QWidget(parent);
    auto* layout = new QHBoxLayout(m_table);
    layout->setContentsMargins(0, 0, 0, 0);
    m_tableText = new QLabel(m_table);
    m_tableText->setObjectName(QStringLiteral("tableText"));
    m_tableText->setAccessibleName(tr("Table of the hammer blow"));
    m_tableText->setWordWrap(true);
    m_tableText->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_reload = new QPushButton(tr("Reload"), m_table);
    m_reload->setObjectName(QStringLiteral("reloadTable"));
    m_reload->setToolTip(tr("Read the CSV file of the hammer blow again"));
    auto* choose = new QPushButton(tr("Choose CSV…"), m_table);
    choose->setObjectName(QStringLiteral("chooseTable"));
    choose->setToolTip(tr("Reads the hammer blow from a CSV file that begins with `time [us],force [kN]`"));
    layout->addWidget(m_tableText, 1);
    layout->addWidget(m_reload, 0, Qt::AlignTop);
    layout->addWidget(choose, 0, Qt::AlignTop);
    grid->addWidget(m_table, grid->rowCount(), 0, 1, formColumns);
    connect(choose, &QPushButton::clicked, this, &PulseSection::chooseTable);
    connect(m_reload, &QPushButton::clicked, this, [this] { tellIfFailed(m_document.reloadTable()); });
}

// A measured blow of another strength: all its forces times one factor.
void PulseSection::addImpulse(QGridLayout* grid, QWidget* parent) {
    const Parameter& parameter = *findParameter("pulse.impulse");
    m_impulse = new QuantityField(parameter, m_document.units(), parent);
    m_impulse->setObjectName(QStringLiteral("table.impulse"));
    m_impulse->setAccessibleName(tr("Hammer blow: impulse of the table"));
    m_impulse->setToolTip(
        tr("Impulse of the table. Another value scales all its forces, and the scenario then contains the "
           "points."));
    m_impulseLabel = new QLabel(tr("impulse I₀"), parent);
    m_impulseLabel->setBuddy(m_impulse);
    m_impulseLabel->setToolTip(m_impulse->toolTip());
    const int row = grid->rowCount();
    grid->addWidget(m_impulseLabel, row, 0);
    grid->addWidget(m_impulse, row, 2);
    grid->addWidget(m_impulse->unitButton(), row, 3);
    m_impulse->unitButton()->setAccessibleName(tr("Hammer blow: impulse of the table, unit"));
    m_impulse->setTaker([this](double impulse) { return offerImpulse(impulse); });
    connect(m_impulse, &QuantityField::editsEnded, this, &PulseSection::scale);
    connect(m_impulse, &QuantityField::unitChosen, this,
            [this, &parameter](const Unit& unit) { m_document.units().chooseForField(parameter, unit); });
}

QString PulseSection::offerImpulse(double impulse) {
    m_wanted.reset();
    const Scenario& scenario = m_document.scenario();
    if (const Message outside = rangeProblem(*findParameter("pulse.impulse"), impulse); !outside.isEmpty())
        return translated(outside);
    if (impulse != pulseImpulse(scenario) && scenario.pulse.tablePoints.size() > mostPointsKept)
        return tr("a table of more than %1 points stays in its file: scale its forces there")
            .arg(mostPointsKept);
    m_wanted = impulse;
    return {};
}

// When the typing has come to its end: one step, whatever was on the way.
void PulseSection::scale() {
    const std::optional<double> wanted = std::exchange(m_wanted, std::nullopt);
    const double present = pulseImpulse(m_document.scenario());
    if (!wanted || *wanted == present || m_document.scenario().pulse.shape != PulseShape::table) return;
    Scenario changed = m_document.scenario();
    std::vector<TablePoint> points(changed.pulse.tablePoints.begin(), changed.pulse.tablePoints.end());
    for (TablePoint& point : points) point.force *= *wanted / present;
    changed.pulse.tablePoints = std::move(points);
    changed.pulse.tableFile.clear();
    tellIfFailed(m_document.useScenario(
        changed, tr("scale the hammer blow to %1").arg(m_document.units().text(*wanted, UnitKind::impulse))));
}

void PulseSection::present(const Scenario& scenario, Shapes shapes) {
    if (shapes == Shapes::asked) showShape();
    m_preview->present(scenario);
    const bool isTable = scenario.pulse.shape == PulseShape::table;
    const bool hasImpulse = isTable && scenario.form == ScenarioForm::dimensional;
    m_table->setVisible(isTable);
    for (QWidget* widget :
         std::initializer_list<QWidget*>{m_impulseLabel, m_impulse, m_impulse->unitButton()})
        widget->setVisible(hasImpulse);
    if (hasImpulse) m_impulse->setValue(pulseImpulse(scenario));
    if (scenario.pulse.shape == PulseShape::table) showTable(scenario);
}

// Only shapes that the scenario can have; a table can always be chosen from a file.
void PulseSection::showShape() {
    const QSignalBlocker quiet(m_shape);
    m_shape->clear();
    for (const std::string_view text : pulseShapeNames()) {
        const PulseShape shape = *findPulseShape(text);
        const bool asksForFile = shape == PulseShape::table && !m_document.canHaveShape(shape);
        if (asksForFile)
            m_shape->addItem(tr("%1 from a file…").arg(shapeText(shape)), static_cast<int>(shape));
        else if (m_document.canHaveShape(shape))
            m_shape->addItem(shapeText(shape), static_cast<int>(shape));
    }
    m_shape->setCurrentIndex(m_shape->findData(static_cast<int>(m_document.scenario().pulse.shape)));
}

void PulseSection::showTable(const Scenario& scenario) {
    m_tableText->setText(tableText(scenario, m_document.units()));
    m_tableText->setToolTip(withoutMarkup(QDir::toNativeSeparators(m_document.tablePath())));
    m_reload->setVisible(!scenario.pulse.tableFile.empty());
}

void PulseSection::chooseShape(PulseShape shape) {
    if (m_document.canHaveShape(shape)) return m_document.setShape(shape);
    chooseTable();
    // Without a table the shape stays what it was.
    showShape();
}

void PulseSection::chooseTable() {
    const QString now = m_document.tablePath();
    const QString folder = QFileInfo(now.isEmpty() ? m_document.suggestedPath() : now).absolutePath();
    const QString path =
        m_questions.fileToImport(m_shape->window(), tr("Take the hammer blow from a CSV file"), folder,
                                 tr("Tables of time and force (*.csv);;All files (*)"));
    if (!path.isEmpty()) tellIfFailed(m_document.useTable(path));
}

void PulseSection::tellIfFailed(const QString& problem) {
    if (!problem.isEmpty())
        m_questions.tell(m_shape->window(), Questions::Tone::failure,
                         tr("The hammer blow cannot be taken from this file."),
                         problem + QLatin1Char('\n') + tr("“Measured…” imports tables of any other form."));
}

}  // namespace drillwave
