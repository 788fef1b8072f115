// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/string/string_edits.h"

#include <QCursor>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QMenu>
#include <QSignalBlocker>
#include <QTableView>
#include <algorithm>
#include <array>

#include "core/model/form_conversion.h"
#include "core/model/section_pieces.h"
#include "core/model/section_words.h"
#include "core/text/handy_text.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "ui/text/language.h"
#include "ui/text/shown_text.h"
#include "ui/text/typed_text.h"

namespace drillwave {
namespace {

constexpr int usualRepeat = 2;

// Where such a piece stands in every string.
std::optional<StringEnd> endOf(SectionPresetKind kind) {
    if (kind == SectionPresetKind::adapter) return StringEnd::shank;
    if (kind == SectionPresetKind::bit) return StringEnd::bit;
    return std::nullopt;
}

// Of a section of an example: as it is called there.
std::optional<StringEnd> endOf(std::string_view name) {
    if (name.starts_with("adapter")) return StringEnd::shank;
    if (name.starts_with("bit")) return StringEnd::bit;
    return std::nullopt;
}

// "rod, 3660 × 39/14.5 mm".
QString describe(const Section& section, const UnitChoice& units) {
    const Unit& unit = units.fieldUnit(*StringModel::ofColumn("diameter"));
    const auto sizeText = [&](double si) { return fieldText(si, Quantity::length, unit, QLocale()); };
    QString size = sizeText(section.length) + QStringLiteral(" × ") + sizeText(outerDiameterAt(section, 0));
    if (!isUniform(section)) size += QStringLiteral("…") + sizeText(outerDiameterAt(section, 1));
    if (!section.area && section.bore > 0) size += QLatin1Char('/') + sizeText(section.bore);
    const QString name =
        section.name.empty() ? StringEdits::tr("section") : translated(sectionNameMessage(section.name));
    return QStringLiteral("%1, %2 %3").arg(name, size, shownUnitName(unit.name));
}

}  // namespace

StringEdits::StringEdits(Document& document, StringModel& model, QTableView& table)
    : QObject(&table),
      m_document(document),
      m_model(model),
      m_table(table),
      m_addMenu(new QMenu(&table)),
      m_replaceMenu(new QMenu(&table)) {
    m_add = newAction(QStringLiteral("add"), tr("Add"),
                      tr("Adds a section after the selected one: a copy, a preset or a section of the "
                         "example strings. Adapters go to the shank, bits to the rock."),
                      QKeySequence(Qt::Key_Insert), [this] {
                          const std::optional<SectionSpot> spot = current();
                          if (!spot) return;
                          Section section = sectionAt(m_document.scenario().drillString, *spot);
                          section.name.clear();
                          add({section});
                      });
    m_add->setMenu(m_addMenu);
    m_replace = newAction(QStringLiteral("replace"), tr("Replace by preset"),
                          tr("Replace the selected sections by a preset"), QKeySequence(Qt::CTRL | Qt::Key_H),
                          [this] { m_replaceMenu->popup(QCursor::pos()); });
    m_replace->setMenu(m_replaceMenu);
    m_duplicate = newAction(QStringLiteral("duplicate"), tr("Duplicate"),
                            tr("Duplicates the selected section, with its name"),
                            QKeySequence(Qt::CTRL | Qt::Key_D), [this] { duplicate(); });
    m_remove = newAction(QStringLiteral("remove"), tr("Remove"), tr("Removes the selected sections"),
                         QKeySequence(Qt::Key_Delete), [this] { remove(); });
    m_up = newAction(QStringLiteral("up"), tr("Towards the hammer"),
                     tr("Move the selected section one step towards the rear, into or out of a repeat"),
                     QKeySequence(Qt::ALT | Qt::Key_Up), [this] { move(MoveTo::rear); });
    m_down = newAction(QStringLiteral("down"), tr("Towards the bit"),
                       tr("Move the selected section one step towards the bit, into or out of a repeat"),
                       QKeySequence(Qt::ALT | Qt::Key_Down), [this] { move(MoveTo::bit); });
    m_repeat = newAction(QStringLiteral("repeat"), tr("Repeat…"),
                         tr("Repeats the selected sections; inside a repeat, type the number of times"),
                         QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_D), [this] { repeat(); });
    connect(m_addMenu, &QMenu::aboutToShow, this, &StringEdits::fillAddMenu);
    connect(m_replaceMenu, &QMenu::aboutToShow, this, &StringEdits::fillReplaceMenu);
    connect(table.selectionModel(), &QItemSelectionModel::selectionChanged, this, &StringEdits::offer);
    connect(&model, &QAbstractItemModel::modelReset, this, &StringEdits::offer);
    connect(&model, &QAbstractItemModel::dataChanged, this, &StringEdits::offer);
    letRowsBeDragged();
    offer();
}

// By their headers; the view's own order stays that of the file.
void StringEdits::letRowsBeDragged() {
    QHeaderView* header = m_table.verticalHeader();
    header->setSectionsMovable(true);
    connect(header, &QHeaderView::sectionMoved, this, [this, header](int /*row*/, int from, int to) {
        const QSignalBlocker blocker(header);
        header->moveSection(to, from);
        // The header is still in the middle of its drag.
        QMetaObject::invokeMethod(
            this, [this, from, to] { moveRow(from, to); }, Qt::QueuedConnection);
    });
}

QAction* StringEdits::newAction(const QString& name, const QString& text, const QString& toolTip,
                                const QKeySequence& keys, const std::function<void()>& then) {
    auto* action = new QAction(text, &m_table);
    action->setObjectName(QStringLiteral("string.") + name);
    action->setShortcut(keys);
    action->setShortcutContext(Qt::WidgetShortcut);
    action->setToolTip(QStringLiteral("%1 (%2)").arg(toolTip, keys.toString(QKeySequence::NativeText)));
    connect(action, &QAction::triggered, this, then);
    m_table.addAction(action);
    m_actions.append(action);
    return action;
}

// Known pieces, so that nobody begins with a blank one.
void StringEdits::fillAddMenu() {
    m_addMenu->clear();
    if (const std::optional<SectionSpot> spot = current()) {
        Section like = sectionAt(m_document.scenario().drillString, *spot);
        like.name.clear();
        addChoice(*m_addMenu, tr("Like the selected one"), {}, adding({like}));
    }
    addPresets();
    addExamples();
}

void StringEdits::addChoice(QMenu& menu, const QString& text, const QString& toolTip,
                            const std::function<void()>& then) {
    menu.addAction(QString(text).replace(u'&', QStringLiteral("&&")), this, then)->setToolTip(toolTip);
}

std::function<void()> StringEdits::adding(std::vector<Section> sections, std::optional<StringEnd> end) {
    return [this, sections = std::move(sections), end] { end ? addAt(*end, sections) : add(sections); };
}

QMenu* StringEdits::newMenu(QMenu& menu, const QString& title) {
    QMenu* sub = menu.addMenu(title);
    sub->setToolTipsVisible(true);
    return sub;
}

void StringEdits::addRods(QMenu& menu, const std::function<void(Section)>& then,
                          std::optional<double> length) {
    const Material& material = m_document.scenario().drillString.material;
    const LocalStyle style = LocalStyle::of(m_document.units());
    QMenu* rods = newMenu(menu, tr("Rods"));
    for (const PresetSource& source : m_presets.sources())
        for (const Preset& preset : source.presets) {
            if (preset.kind != PresetKind::rod) continue;
            Section rod = sectionOf(withPreset({}, preset).rod, material);
            rod.preset = preset.name;
            const bool hasLength = std::ranges::any_of(
                preset.values, [](const PresetValue& value) { return value.parameter->key == "rod.length"; });
            if (length && !hasLength) rod.length = *length;
            addChoice(*rods, coreText(preset.name), QString::fromStdString(description(preset, style)),
                      [then, rod] { then(rod); });
        }
}

void StringEdits::addPieces(QMenu& menu, SectionPresetKind kind,
                            const std::function<void(const SectionPreset&)>& then) {
    static_assert(sectionPresetKinds.size() == 4, "a title for each kind");
    const std::array<QString, sectionPresetKinds.size()> titles{tr("Hammer, instead of this one"),
                                                                tr("Adapters"), tr("Couplings"), tr("Bits")};
    const LocalStyle style = LocalStyle::of(m_document.units());
    QMenu* pieces = newMenu(menu, titles[static_cast<std::size_t>(kind)]);
    for (const PresetSource& source : m_presets.sources())
        for (const SectionPreset& preset : source.sectionPresets)
            if (preset.kind == kind)
                addChoice(*pieces, coreText(preset.name), QString::fromStdString(description(preset, style)),
                          [then, preset] { then(preset); });
}

void StringEdits::addPresets() {
    m_presets.reload();
    m_addMenu->addSection(tr("Presets"));
    addRods(*m_addMenu, [this](const Section& rod) { add({rod}); });
    for (const SectionPresetKind kind : sectionPresetKinds)
        addPieces(*m_addMenu, kind, [this](const SectionPreset& preset) {
            if (preset.kind == SectionPresetKind::piston) return useHammer(preset);
            adding(preset.sections, endOf(preset.kind))();
        });
}

void StringEdits::fillReplaceMenu() {
    m_replaceMenu->clear();
    const std::vector<SectionSpot> spots = selected();
    if (!canReplace(m_document.scenario().drillString, spots)) return;
    m_presets.reload();
    addRods(
        *m_replaceMenu, [this](const Section& rod) { replace({rod}); },
        sectionAt(m_document.scenario().drillString, spots.front()).length);
    for (const SectionPresetKind kind : sectionPresetKinds)
        if (kind != SectionPresetKind::piston)
            addPieces(*m_replaceMenu, kind,
                      [this](const SectionPreset& preset) { replace(preset.sections); });
}

void StringEdits::addExamples() {
    m_addMenu->addSection(tr("From the example strings"));
    for (const Example& example : builtInExamples()) {
        if (!example.ofString) continue;
        QMenu* menu = m_addMenu->addMenu(coreText(example.title));
        for (const StringRow& row :
             stringRows(parseScenario(example.text, example.name).scenario.drillString))
            addChoice(*menu, describe(row.section, m_document.units()), {},
                      adding({row.section}, endOf(row.section.name)));
    }
}

std::vector<SectionSpot> StringEdits::selected() const {
    std::vector<int> rows;
    for (const QModelIndex& index : m_table.selectionModel()->selectedRows()) rows.push_back(index.row());
    std::ranges::sort(rows);
    std::vector<SectionSpot> spots;
    for (const int row : rows)
        if (row < m_model.rowCount()) spots.push_back(m_model.rows()[static_cast<std::size_t>(row)].spot);
    return spots;
}

// The last one selected; of a table without selection the last row.
std::optional<SectionSpot> StringEdits::current() const {
    const std::vector<SectionSpot> spots = selected();
    if (!spots.empty()) return spots.back();
    if (m_model.rows().empty()) return std::nullopt;
    return m_model.rows().back().spot;
}

void StringEdits::select(const SectionSpot& spot) {
    const int row = m_model.rowOf(spot);
    if (row < 0) return;
    const QModelIndex index = m_model.index(row, StringModel::sectionName);
    m_table.selectionModel()->setCurrentIndex(
        index, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    m_table.scrollTo(index);
}

void StringEdits::offer() {
    const std::vector<SectionSpot> spots = selected();
    const bool isOne = spots.size() == 1;
    const DrillString& drill = m_document.scenario().drillString;
    const bool isThere = !m_model.rows().empty();
    m_add->setEnabled(isThere);
    m_duplicate->setEnabled(isThere && isOne);
    m_replace->setEnabled(isThere && canReplace(drill, spots) && !spots.front().inHammer);
    m_remove->setEnabled(isThere && !spots.empty());
    const auto canMove = [&](MoveTo direction) {
        DrillString tried = drill;
        return isThere && isOne && moveSection(tried, spots.front(), direction).has_value();
    };
    m_up->setEnabled(canMove(MoveTo::rear));
    m_down->setEnabled(canMove(MoveTo::bit));
    const bool isInRepeat =
        isThere && isOne && !spots.front().inHammer && drill.parts[spots.front().part].group;
    m_repeat->setEnabled(isThere && (isInRepeat || canRepeat(drill, spots)));
}

bool StringEdits::take(const Scenario& changed, const QString& step) {
    const QString problem = m_document.useScenario(changed, step);
    emit refused(problem);
    return problem.isEmpty();
}

void StringEdits::add(const std::vector<Section>& sections) {
    const std::optional<SectionSpot> after = current();
    if (!after) return;
    Scenario changed = m_document.scenario();
    std::vector<Section> added = sections;
    if (after->inHammer)
        for (Section& section : added) section.loss = section.attenuation = 0;
    const SectionSpot spot = insertBehind(changed.drillString, *after, added);
    takeAdded(changed, sections, spot);
}

void StringEdits::takeAdded(const Scenario& changed, const std::vector<Section>& sections,
                            const SectionSpot& last) {
    const std::string& first = sections.front().name;
    const QString what = sections.size() > 1 ? tr("%1 sections").arg(sections.size())
                         : first.empty()     ? tr("a section")
                                             : QString::fromStdString(first);
    if (take(changed, tr("add %1").arg(what))) select(last);
}

void StringEdits::addAt(StringEnd end, const std::vector<Section>& sections) {
    if (m_model.rows().empty()) return;
    Scenario changed = m_document.scenario();
    const SectionSpot last = insertAt(changed.drillString, end, sections);
    takeAdded(changed, sections, last);
}

void StringEdits::useHammer(const SectionPreset& piston) {
    Scenario changed = m_document.scenario();
    changed.drillString.hammer = withPiston(changed.drillString.hammer, piston);
    if (take(changed, tr("take the hammer %1").arg(QString::fromStdString(piston.name))))
        select({.inHammer = true, .part = 0, .index = 0});
}

void StringEdits::replace(const std::vector<Section>& sections) {
    const std::vector<SectionSpot> spots = selected();
    Scenario changed = m_document.scenario();
    if (!canReplace(changed.drillString, spots)) return;
    const QString name = spots.size() == 1 ? m_model.rows()[std::size_t(m_model.rowOf(spots.front()))].name()
                                           : tr("%1 sections").arg(spots.size());
    const SectionSpot last = replaceSections(changed.drillString, spots, sections);
    if (take(changed, tr("replace %1 by %2").arg(name, coreText(sections.front().preset)))) select(last);
}

void StringEdits::duplicate() {
    const std::vector<SectionSpot> spots = selected();
    if (spots.size() != 1) return;
    Scenario changed = m_document.scenario();
    const Section copy = sectionAt(changed.drillString, spots.front());
    const QString name = m_model.rows()[std::size_t(m_model.rowOf(spots.front()))].name();
    const SectionSpot spot = insertAfter(changed.drillString, spots.front(), copy);
    if (take(changed, tr("duplicate %1").arg(name))) select(spot);
}

// From the end, so that those before stay where they are.
void StringEdits::remove() {
    const std::vector<SectionSpot> spots = selected();
    if (spots.empty()) return;
    Scenario changed = m_document.scenario();
    const int row = m_model.rowOf(spots.front());
    const QString name = m_model.rows()[std::size_t(row)].name();
    for (auto spot = spots.rbegin(); spot != spots.rend(); ++spot) {
        if (!canRemove(changed.drillString, *spot))
            return emit refused(spot->inHammer ? tr("A hammer has at least one section.")
                                               : tr("A string has at least one section."));
        removeSection(changed.drillString, *spot);
    }
    const QString step =
        spots.size() == 1 ? tr("remove %1").arg(name) : tr("remove %1 sections").arg(spots.size());
    if (!take(changed, step)) return;
    select(m_model.rows()[std::size_t(std::min(row, m_model.rowCount() - 1))].spot);
}

void StringEdits::move(MoveTo direction) {
    const std::vector<SectionSpot> spots = selected();
    if (spots.size() != 1) return;
    const QString name = m_model.rows()[std::size_t(m_model.rowOf(spots.front()))].name();
    Scenario changed = m_document.scenario();
    const std::optional<SectionSpot> spot = moveSection(changed.drillString, spots.front(), direction);
    if (!spot) return;
    const QString step =
        direction == MoveTo::rear ? tr("move %1 towards the hammer") : tr("move %1 towards the bit");
    if (take(changed, step.arg(name))) select(*spot);
}

void StringEdits::moveRow(int from, int to) {
    if (from >= m_model.rowCount() || to >= m_model.rowCount() || from == to) return;
    Scenario changed = m_document.scenario();
    SectionSpot spot = m_model.rows()[std::size_t(from)].spot;
    const QString name = m_model.rows()[std::size_t(from)].name();
    const auto row = [&] {
        const std::vector<SectionSpot> spots = sectionSpots(changed.drillString);
        return int(std::ranges::find(spots, spot) - spots.begin());
    };
    // Into and out of repeats as by single steps.
    while (to < from ? row() > to : row() < to) {
        const std::optional<SectionSpot> next =
            moveSection(changed.drillString, spot, to < from ? MoveTo::rear : MoveTo::bit);
        if (!next)
            return emit refused(
                tr("Sections of the hammer stay in the hammer, sections of the string in the string."));
        spot = *next;
    }
    if (take(changed, tr("move %1").arg(name))) select(spot);
}

void StringEdits::repeat() {
    const std::vector<SectionSpot> spots = selected();
    if (spots.empty()) return;
    Scenario changed = m_document.scenario();
    SectionSpot spot = spots.front();
    if (canRepeat(changed.drillString, spots)) {
        repeatSections(changed.drillString, spots, usualRepeat);
        spot.index = 0;
        const QString name = m_model.rows()[std::size_t(m_model.rowOf(spots.front()))].name();
        const QString what = spots.size() == 1 ? name : tr("%1 sections").arg(spots.size());
        if (!take(changed, tr("repeat %1").arg(what))) return;
        select(spot);
    }
    const QModelIndex cell = m_model.index(m_model.rowOf(spot), StringModel::repeat);
    if (cell.isValid() && (m_model.flags(cell) & Qt::ItemIsEditable)) {
        m_table.setCurrentIndex(cell);
        m_table.edit(cell);
    }
}

}  // namespace drillwave
