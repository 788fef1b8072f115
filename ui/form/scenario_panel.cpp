// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/scenario_panel.h"

#include <QDockWidget>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "core/model/blow_traits.h"
#include "core/model/law_parameter.h"
#include "core/model/scales.h"
#include "core/model/section_words.h"
#include "ui/form/choice_box.h"
#include "ui/form/parameter_row.h"
#include "ui/text/shown_text.h"

namespace drillwave {

namespace {

const QString groupsSection = QStringLiteral("groups");
const QString stringSection = QStringLiteral("string");
const QString machineSection = QStringLiteral("machine");

// Where in the form a parameter is: what a string has beside its sections stands together, and so does what
// counts over many blows alone.
QString formSection(const Parameter& parameter) {
    if (parameter.scope == Scope::manyBlows) return machineSection;
    const QString section = fromView(parameter.section());
    return section.isEmpty() || section == QLatin1String("material") ? stringSection : section;
}

std::optional<PresetKind> presetsOf(const QString& section) {
    if (section == QLatin1String("rod")) return PresetKind::rod;
    if (section == QLatin1String("pulse")) return PresetKind::hammer;
    if (section == QLatin1String("bit_rock")) return PresetKind::rock;
    return std::nullopt;
}

}  // namespace

IndexingBox::IndexingBox(Document& document, QGridLayout* grid, QWidget* parent)
    : QObject(parent), m_document(document), m_box(new ChoiceBox(parent)) {
    auto* label = new QLabel(tr("rock"), parent);
    label->setBuddy(m_box);
    m_box->setObjectName(QStringLiteral("drill.indexing"));
    m_box->setAccessibleName(tr("Machine: rock"));
    m_box->setToolTip(tr("Whether each blow meets new rock, or the crater of the blow before"));
    for (const QString& words : {tr("new for every blow"), tr("the same crater")}) m_box->addItem(words);
    const int row = grid->rowCount();
    grid->addWidget(label, row, 0);
    grid->addWidget(m_box, row, 1, 1, formColumns - 1);
    connect(m_box, &QComboBox::activated, this,
            [this](int chosen) { choose(chosen == 0 ? RockIndexing::fresh : RockIndexing::same); });
}

void IndexingBox::present(const Scenario& scenario) {
    const QSignalBlocker quiet(m_box);
    m_box->setCurrentIndex(scenario.drill.indexing == RockIndexing::fresh ? 0 : 1);
}

void IndexingBox::choose(RockIndexing indexing) {
    Scenario changed = m_document.scenario();
    if (changed.drill.indexing == indexing) return;
    changed.drill.indexing = indexing;
    m_document.useScenario(changed, tr("change the rock of the next blow"));
    present(m_document.scenario());
}

StringSection::StringSection(Document& document, QGridLayout* grid, QWidget* parent)
    : QObject(parent), m_document(document), m_summary(new QLabel(parent)) {
    m_summary->setObjectName(QStringLiteral("stringSummary"));
    m_summary->setWordWrap(true);
    m_summary->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_summary->setToolTip(tr("Closed forms and groups are for uniform rods only"));
    auto* sections = new QPushButton(tr("Sections…"), parent);
    sections->setObjectName(QStringLiteral("sections"));
    sections->setToolTip(tr("The page String: a drawing, and all sections in a table to edit"));
    connect(sections, &QPushButton::clicked, this, &StringSection::sectionsRequested);
    const int row = grid->rowCount();
    grid->addWidget(m_summary, row, 0, 1, formColumns - 2);
    grid->addWidget(sections, row, formColumns - 2, 1, 2, Qt::AlignTop);
}

void StringSection::addRestrike(QGridLayout* grid, QWidget* parent) {
    m_restrike = new QCheckBox(tr("may strike again"), parent);
    m_restrike->setObjectName(QStringLiteral("hammer.restrike"));
    m_restrike->setAccessibleName(tr("Hammer: may strike again"));
    m_restrike->setToolTip(tr(
        "The hammer may be hit again by the string; otherwise it is withdrawn after the first separation"));
    grid->addWidget(m_restrike, grid->rowCount(), 0, 1, formColumns);
    connect(m_restrike, &QCheckBox::clicked, this, &StringSection::setRestrike);
}

void StringSection::setRestrike(bool restrike) {
    Scenario changed = m_document.scenario();
    changed.drillString.hammer.restrike = restrike;
    m_document.useScenario(changed, restrike ? tr("let the hammer strike again") : tr("withdraw the hammer"));
}

void StringSection::present(const Scenario& scenario) {
    const DrillString& drill = scenario.drillString;
    const ChainProperties string = stringProperties(drill);
    const auto text = [this](double si, UnitKind kind) { return m_document.units().text(si, kind, 4); };
    QString summary = QStringLiteral("%1, %2, %3")
                          .arg(translated(stringWords(drill)), text(string.length, UnitKind::length),
                               text(string.mass, UnitKind::mass));
    if (!isForced(scenario)) {
        const ChainProperties hammer = hammerProperties(drill);
        summary += tr("; hammer %1, %2")
                       .arg(text(hammer.length, UnitKind::length), text(hammer.mass, UnitKind::mass));
    }
    m_summary->setText(summary);
    m_restrike->setChecked(drill.hammer.restrike);
}

ScenarioPanel::ScenarioPanel(Document& document, Questions& questions, QWidget* parent)
    : SteadyScrollArea(parent), m_document(document), m_questions(questions) {
    setWidget(new QWidget);
    auto* layout = new QVBoxLayout(widget());
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(6);
    addTitle();
    addSection(stringSection, tr("String"));
    addSection(QStringLiteral("hammer"), tr("Hammer"));
    addSection(QStringLiteral("rod"), tr("Rod"));
    addSection(QStringLiteral("pulse"), tr("Hammer blow"));
    addSection(QStringLiteral("bit_rock"), tr("Bit and rock"));
    addSection(QStringLiteral("drill"), tr("Drill"));
    addSection(machineSection, tr("Machine"));
    addSection(groupsSection, tr("Groups"));
    layout->addStretch();
    alignColumns();
    connect(&document, &Document::scenarioChanged, this, &ScenarioPanel::showScenario);
    connect(&document.units(), &UnitChoice::changed, this, [this] {
        alignColumns();
        showScenario();
    });
    showScenario();
}

// Sliders that are held and fields with the focus hand their edits over as they go out of sight: while the
// panel and the document are still there.
ScenarioPanel::~ScenarioPanel() {
    hide();
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
    box->setObjectName(section);
    if (section != groupsSection)
        box->rememberAs(QStringLiteral("panel/") + section,
                        section == machineSection ? SectionBox::Begin::folded : SectionBox::Begin::open);
    auto* grid = new QGridLayout(box->content());
    grid->setContentsMargins(4, 0, 0, 0);
    grid->setHorizontalSpacing(5);
    grid->setVerticalSpacing(3);
    grid->setColumnStretch(1, 1);
    m_sections.append({box, grid, {}});
    if (const std::optional<PresetKind> kind = presetsOf(section))
        addPresets(*kind, title, grid, box->content());
    if (section == QLatin1String("pulse")) {
        m_pulse = new PulseSection(m_document, m_questions, grid, box->content());
        connect(m_pulse, &PulseSection::importRequested, this, &ScenarioPanel::importRequested);
    }
    if (section == stringSection) {
        m_string = new StringSection(m_document, grid, box->content());
        connect(m_string, &StringSection::sectionsRequested, this, &ScenarioPanel::sectionsRequested);
    }
    for (const Parameter& parameter : parameters()) {
        if (formSection(parameter) != section) continue;
        addRow(parameter, title, grid, box->content());
        // What is measured in scales where a scenario has no units; one of the two rows is shown.
        if (const KeptParameter inScale = inScales(parameter)) addRow(*inScale, title, grid, box->content());
    }
    if (section == machineSection) m_indexing = new IndexingBox(m_document, grid, box->content());
    if (section == QLatin1String("bit_rock")) m_law = new LawSection(m_document, grid, box->content());
    if (section == QLatin1String("hammer")) m_string->addRestrike(grid, box->content());
    widget()->layout()->addWidget(box);
}

void ScenarioPanel::addPresets(PresetKind kind, const QString& title, QGridLayout* grid, QWidget* parent) {
    auto* label = new QLabel(tr("preset"), parent);
    auto* box = new PresetBox(kind, title, m_document, m_presets, m_questions, parent);
    label->setBuddy(box);
    const int row = grid->rowCount();
    grid->addWidget(label, row, 0);
    grid->addWidget(box, row, 1, 1, 3);
    connect(box, &PresetBox::libraryChanged, this, &ScenarioPanel::showPresets);
    m_presetBoxes.append(box);
}

void ScenarioPanel::addRow(const Parameter& parameter, const QString& sectionTitle, QGridLayout* grid,
                           QWidget* parent) {
    auto* row = new ParameterRow(parameter, m_document.units(), sectionTitle, grid, parent);
    m_sections.last().rows.append(row);
    row->setTaker([this, &parameter](double si) { return m_document.assign(parameter, si, m_gesture); });
    if (parameter.rules.clear) row->field()->setOptional(tr("not given"));
    connect(row, &ParameterRow::cleared, this,
            [this, &parameter] { m_document.clear(parameter, m_gesture); });
    connect(row, &ParameterRow::goalRequested, this,
            [this, &parameter] { emit goalRequested(fromView(parameter.key)); });
    connect(row, &ParameterRow::resetRequested, this, [this, &parameter] { reset(parameter); });
    connect(row->slider(), &QSlider::sliderPressed, this, &ScenarioPanel::beginDrag);
    connect(row->slider(), &QSlider::sliderReleased, this, &ScenarioPanel::endDrag);
    // A slider that was held stands where the hand was, which may not be what the document took.
    connect(row, &ParameterRow::editsEnded, this, [this, row] {
        m_gesture = m_document.newGesture();
        row->present(m_document.scenario());
    });
}

// What the file says, or a new scenario where there is none. Its first click may have moved the slider: that
// is a step of its own.
void ScenarioPanel::reset(const Parameter& parameter) {
    const Scenario& file = m_document.source().scenario;
    if (!parameter.applies(file)) return;
    const int gesture = m_document.newGesture();
    if (const std::optional<double> value = parameter.value(file))
        m_document.assign(parameter, *value, gesture);
    else
        m_document.clear(parameter, gesture);
}

// Nobody looks into the menu of shapes while the hand is at a slider.
void ScenarioPanel::beginDrag() {
    m_dragged = true;
    emit dragStarted();
}

void ScenarioPanel::endDrag() {
    m_dragged = false;
    if (isForced(m_document.scenario())) m_pulse->present(m_document.scenario(), PulseSection::Shapes::asked);
    emit dragEnded();
}

// One set of columns through all sections. The long units of a machine, which is folded at first, make them
// no wider.
void ScenarioPanel::alignColumns() {
    int label = 0;
    int unit = 0;
    for (const Section& section : std::as_const(m_sections)) {
        if (section.box->objectName() == machineSection) continue;
        for (const ParameterRow* row : section.rows) {
            label = std::max(label, row->labelWidth());
            unit = std::max(unit, row->unitWidth());
        }
    }
    for (const Section& section : std::as_const(m_sections)) {
        section.grid->setColumnMinimumWidth(0, label);
        section.grid->setColumnMinimumWidth(3, unit);
    }
}

void ScenarioPanel::showScenario() {
    const Scenario& scenario = m_document.scenario();
    placeGroups(scenario.form);
    const QString title = QString::fromStdString(scenario.title);
    if (m_title->text() != title) m_title->setText(title);
    showPresets();
    const bool isOfSections = hasSections(scenario);
    if (isOfSections) m_string->present(scenario);
    m_law->present(scenario);
    m_indexing->present(scenario);
    if (isForced(scenario))
        m_pulse->present(scenario, m_dragged ? PulseSection::Shapes::asBefore : PulseSection::Shapes::asked);
    for (const Section& section : std::as_const(m_sections)) {
        for (ParameterRow* row : section.rows) row->present(scenario);
        const bool used = std::ranges::any_of(
            section.rows, [&](const ParameterRow* row) { return row->parameter().applies(scenario); });
        const QString name = section.box->objectName();
        section.box->setVisible(name == QLatin1String("pulse")      ? isForced(scenario)
                                : name == groupsSection             ? !isOfSections
                                : name == QLatin1String("bit_rock") ? true
                                                                    : used);
    }
}

// What follows from the rest comes last, folded; what is all that is given comes first. Each is remembered
// as it was left.
void ScenarioPanel::placeGroups(ScenarioForm form) {
    if (m_placedFor == form) return;
    m_placedFor = form;
    const bool first = form == ScenarioForm::dimensionless;
    const auto groups = std::ranges::find_if(
        m_sections, [](const Section& each) { return each.box->objectName() == groupsSection; });
    if (first)
        std::rotate(m_sections.begin(), groups, std::next(groups));
    else
        std::rotate(groups, std::next(groups), m_sections.end());
    SectionBox* box = first ? m_sections.first().box : m_sections.last().box;
    auto* layout = static_cast<QVBoxLayout*>(widget()->layout());
    layout->insertWidget(first ? layout->indexOf(m_title) + 1 : layout->count() - 1, box);
    box->rememberAs(QStringLiteral("panel/") + (first ? QStringLiteral("givenGroups") : groupsSection),
                    first ? SectionBox::Begin::open : SectionBox::Begin::folded);
    orderTabs();
}

// The keyboard goes from top to bottom.
void ScenarioPanel::orderTabs() {
    QWidgetList chain;
    for (const Section& section : std::as_const(m_sections))
        for (QWidget* next = section.box->nextInFocusChain(); next != section.box;
             next = next->nextInFocusChain())
            if (section.box->isAncestorOf(next)) chain.append(next);
    QWidget* before = m_title;
    for (QWidget* next : std::as_const(chain)) {
        setTabOrder(before, next);
        before = next;
    }
}

void ScenarioPanel::showPresets() {
    for (PresetBox* box : std::as_const(m_presetBoxes)) box->present(m_document.scenario());
}

void ScenarioPanel::goTo(const QString& key) {
    auto* field = widget()->findChild<QWidget*>(key);
    if (!field) return;
    for (const Section& section : std::as_const(m_sections))
        if (section.box->isAncestorOf(field)) section.box->setOpen(true);
    if (auto* dock = qobject_cast<QDockWidget*>(parentWidget())) {
        dock->show();
        dock->raise();
    }
    ensureWidgetVisible(field);
    field->setFocus(Qt::OtherFocusReason);
}

}  // namespace drillwave
