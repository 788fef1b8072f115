#include "ui/scenario_panel.h"

#include <QGridLayout>
#include <QLabel>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>

#include "core/model/optional_parameter.h"

namespace drillwave {
namespace {

// Combo boxes too must let the panel scroll while they have no focus.
class ShapeBox : public QComboBox {
  public:
    using QComboBox::QComboBox;

  protected:
    void wheelEvent(QWheelEvent* event) override {
        if (hasFocus())
            QComboBox::wheelEvent(event);
        else
            event->ignore();
    }
};

QString shapeText(PulseShape shape) {
    const std::string_view text = name(shape);
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())).replace(u'_', u' ');
}

}  // namespace

ScenarioPanel::ScenarioPanel(Document& document, QWidget* parent)
    : QScrollArea(parent), m_document(document) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setWidget(new QWidget);
    auto* layout = new QVBoxLayout(widget());
    layout->setContentsMargins(6, 6, 6, 6);
    layout->setSpacing(8);
    addTitle();
    addSection(QStringLiteral("groups"), tr("Groups"));
    addSection(QStringLiteral("rod"), tr("Rod"));
    addSection(QStringLiteral("pulse"), tr("Hammer blow"));
    addSection(QStringLiteral("bit_rock"), tr("Bit and rock"));
    addSection(QStringLiteral("drill"), tr("Drill"));
    layout->addStretch();
    alignColumns();
    connect(&document, &Document::scenarioChanged, this, &ScenarioPanel::showScenario);
    showScenario();
}

void ScenarioPanel::addTitle() {
    m_title = new QLineEdit(widget());
    m_title->setObjectName(QStringLiteral("title"));
    m_title->setPlaceholderText(tr("Title of the scenario"));
    m_title->setAccessibleName(tr("Title of the scenario"));
    connect(m_title, &QLineEdit::editingFinished, this, [this] { m_document.setTitle(m_title->text()); });
    widget()->layout()->addWidget(m_title);
}

void ScenarioPanel::addSection(const QString& section, const QString& title) {
    auto* box = new SectionBox(title, widget());
    auto* grid = new QGridLayout(box->content());
    grid->setContentsMargins(8, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(3);
    grid->setColumnStretch(1, 1);
    m_sections.append({box, grid, {}});
    if (section == QLatin1String("pulse")) addShape(grid, box->content());
    for (const Parameter& parameter : parameters())
        if (parameter.section() == section.toStdString()) addRow(parameter, title, grid, box->content());
    widget()->layout()->addWidget(box);
}

void ScenarioPanel::addShape(QGridLayout* grid, QWidget* parent) {
    auto* label = new QLabel(tr("shape"), parent);
    m_shape = new ShapeBox(parent);
    m_shape->setObjectName(QStringLiteral("pulse.shape"));
    m_shape->setFocusPolicy(Qt::StrongFocus);
    m_shape->setAccessibleName(tr("Hammer blow: shape"));
    m_shape->setToolTip(tr("Shape of the force of the hammer on the rod over time"));
    label->setBuddy(m_shape);
    grid->addWidget(label, 0, 0);
    grid->addWidget(m_shape, 0, 1, 1, 3);
    connect(m_shape, &QComboBox::activated, this, [this](int index) {
        m_document.setShape(static_cast<PulseShape>(m_shape->itemData(index).toInt()));
    });
}

void ScenarioPanel::addRow(const Parameter& parameter, const QString& sectionTitle, QGridLayout* grid,
                           QWidget* parent) {
    auto* row = new ParameterRow(parameter, sectionTitle, grid, parent);
    m_sections.last().rows.append(row);
    row->field()->setCheck([this, &parameter](double si) { return m_document.whyNot(parameter, si); });
    Scenario probe;
    if (optionalValue(probe, parameter.key)) row->field()->setOptional(tr("not given"));
    connect(row, &ParameterRow::edited, this,
            [this, &parameter](double si) { m_document.assign(parameter, si, m_gesture); });
    connect(row, &ParameterRow::cleared, this,
            [this, &parameter] { m_document.clear(parameter, m_gesture); });
    connect(row->slider(), &QSlider::sliderPressed, this, &ScenarioPanel::dragStarted);
    connect(row->slider(), &QSlider::sliderReleased, this, &ScenarioPanel::dragEnded);
    connect(row, &ParameterRow::editsEnded, this, [this] { ++m_gesture; });
}

// One set of columns through all sections.
void ScenarioPanel::alignColumns() {
    int label = 0;
    int unit = 0;
    for (const Section& section : std::as_const(m_sections))
        for (const ParameterRow* row : section.rows) {
            label = std::max(label, row->labelWidth());
            unit = std::max(unit, row->unitWidth());
        }
    for (const Section& section : std::as_const(m_sections)) {
        section.grid->setColumnMinimumWidth(0, label);
        section.grid->setColumnMinimumWidth(3, unit);
    }
}

void ScenarioPanel::showScenario() {
    const Scenario& scenario = m_document.scenario();
    const QString title = QString::fromStdString(scenario.title);
    if (m_title->text() != title) m_title->setText(title);
    showShape();
    for (const Section& section : std::as_const(m_sections)) {
        for (ParameterRow* row : section.rows) row->show(scenario);
        const bool used = std::ranges::any_of(
            section.rows, [&](const ParameterRow* row) { return row->parameter().applies(scenario); });
        section.box->setVisible(used || section.box->isAncestorOf(m_shape));
    }
}

// Only shapes that the scenario can have: a table needs its points first.
void ScenarioPanel::showShape() {
    const QSignalBlocker quiet(m_shape);
    m_shape->clear();
    for (const std::string_view text : pulseShapeNames()) {
        const PulseShape shape = *findPulseShape(text);
        if (m_document.canHaveShape(shape)) m_shape->addItem(shapeText(shape), static_cast<int>(shape));
    }
    m_shape->setCurrentIndex(m_shape->findData(static_cast<int>(m_document.scenario().pulse.shape)));
}

QSize ScenarioPanel::sizeHint() const {
    const QSize content = widget()->sizeHint();
    return {content.width() + verticalScrollBar()->sizeHint().width() + 2, std::min(content.height(), 900)};
}

QSize ScenarioPanel::minimumSizeHint() const {
    return {widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width() + 2, 200};
}

}  // namespace drillwave
