// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/document.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <algorithm>

#include "core/archive/result_scenario.h"
#include "core/yaml/preset_file.h"
#include "core/yaml/pulse_reader.h"
#include "ui/document/scenario_edit.h"
#include "ui/document/table_name.h"
#include "ui/document/whole_file.h"
#include "ui/text/shown_text.h"
#include "ui/text/typed_text.h"

namespace drillwave {
namespace {

constexpr int undoLimit = 1000;

std::string nativePath(const QString& path) {
    return QFile::encodeName(path).toStdString();
}

QString keyOf(const Parameter& parameter) {
    return fromView(parameter.key);
}

const std::string changedWord = ", changed";

// The comment at the head of an example is about its values.
std::string withoutHead(const std::string& text) {
    std::size_t begin = 0;
    while (begin < text.size() && text[begin] == '#')
        begin = std::min(text.find('\n', begin), text.size() - 1) + 1;
    return text.substr(begin);
}

/// "bore must be less than the diameter", where files have a key and its value.
QString inWordsOfTheForm(const InputProblem& problem, const Scenario& scenario) {
    const KeptParameter parameter = findParameter(problem.key);
    if (!parameter || problem.reason.arguments.empty()) return translated(problem.text);
    return parameterLabel(*parameter, scenario) + QLatin1Char(' ') +
           translated(problem.reason.arguments.back());
}

QString inWordsOfTheForm(const std::string& name, const std::vector<InputProblem>& problems,
                         const Scenario& scenario) {
    QStringList lines;
    for (const InputProblem& problem : problems)
        lines << (name.empty() ? QString() : QString::fromStdString(name) + QStringLiteral(": ")) +
                     inWordsOfTheForm(problem, scenario);
    return lines.join(u'\n');
}

// "t38_rod_medium_rock" of "T38 rod, medium rock": letters and digits of any script, which every system
// takes.
QString fileStemOf(const std::string& title) {
    constexpr qsizetype longest = 60;
    QString stem;
    for (const QChar c : QString::fromStdString(title).toLower())
        if (c.isLetterOrNumber())
            stem += c;
        else if (!stem.isEmpty() && !stem.endsWith(u'_'))
            stem += u'_';
    stem.truncate(longest);
    while (stem.endsWith(u'_')) stem.chop(1);
    return stem.isEmpty() ? QStringLiteral("scenario") : stem;
}

}  // namespace

Document::Document(QObject* parent, Check check) : QObject(parent), m_check(std::move(check)) {
    m_undoStack.setUndoLimit(undoLimit);
    connect(&m_undoStack, &QUndoStack::cleanChanged, this, &Document::stateChanged);
    // A step is in the history only after it has been done. The owner of clear() reports emptying, except in
    // the destructor.
    connect(&m_undoStack, &QUndoStack::indexChanged, this, [this] {
        if (m_undoStack.count() > 0) emit stateChanged();
    });
}

QString shownValue(const Parameter& parameter, double si) {
    const Unit& unit = parameter.displayUnit();
    const QString number = QLocale().toString(unit.fromSi(si), 'g', 4);
    return unit.name.empty() ? number : number + QLatin1Char(' ') + shownUnitName(unit.name);
}

bool Document::isModified() const {
    return hasUnsaved([](const QUndoCommand& step) {
        return dynamic_cast<const ScenarioEdit*>(&step) || dynamic_cast<const DesignEdit*>(&step);
    });
}

bool Document::isScenarioModified() const {
    return hasUnsaved(
        [](const QUndoCommand& step) { return dynamic_cast<const ScenarioEdit*>(&step) != nullptr; });
}

bool Document::hasUnsaved(const std::function<bool(const QUndoCommand&)>& counts) const {
    if (m_undoStack.cleanIndex() < 0) return true;
    const auto [from, to] = std::minmax({m_undoStack.cleanIndex(), m_undoStack.index()});
    for (int i = from; i < to; ++i)
        if (counts(*m_undoStack.command(i))) return true;
    return false;
}

QString Document::displayName() const {
    if (!m_scenario.title.empty()) return QString::fromStdString(m_scenario.title);
    return m_path.isEmpty() ? tr("Untitled") : QFileInfo(m_path).fileName();
}

QString Document::suggestedPath() const {
    if (!m_path.isEmpty()) return m_path;
    if (m_origin.isEmpty()) return fileStemOf(m_scenario.title) + QStringLiteral(".yaml");
    const QFileInfo origin(m_origin);
    return origin.dir().filePath(origin.completeBaseName() + QStringLiteral(".yaml"));
}

bool Document::isChangedExample() const {
    if (!m_example) return false;
    Scenario example = *m_example;
    example.title = m_scenario.title;
    return example != m_scenario;
}

ScenarioDocument Document::contents() const {
    return {m_scenario, isChangedExample() ? withoutHead(m_text) : m_text, m_source.source, m_design};
}

// Restores an example's own title together with its values; otherwise marks it as changed.
void Document::nameChanged(Scenario& after) const {
    if (!m_example || m_example->title.empty()) return;
    const std::string& own = m_example->title;
    if (after.title != own && after.title != own + changedWord) return;
    after.title = own;
    if (after != *m_example) after.title += changedWord;
}

QByteArray Document::text() const {
    return QByteArray::fromStdString(writeScenario(contents()));
}

QString Document::assign(const Parameter& parameter, double si, int gesture) {
    return assign({{parameter, si}}, gesture);
}

QString Document::assign(const std::vector<ParameterValue>& values, int gesture) {
    Scenario changed = m_scenario;
    if (const QString problem = change(changed, values); !problem.isEmpty()) return problem;
    QStringList steps, keys;
    for (const auto& [parameter, si] : values) {
        steps << tr("%1 to %2").arg(parameterTitle(*parameter, m_scenario), shownValue(*parameter, si));
        keys << keyOf(*parameter);
    }
    push(std::move(changed), tr("change %1").arg(steps.join(QStringLiteral(", "))),
         keys.join(QLatin1Char(' ')), gesture);
    return {};
}

QString Document::change(Scenario& scenario, const std::vector<ParameterValue>& values) const {
    for (const auto& [parameter, si] : values) {
        const Message outside = rangeProblem(*parameter, si);
        if (!outside.isEmpty()) return translated(outside);
        parameter->assign(scenario, si);
    }
    const std::vector<InputProblem> problems = m_check(scenario);
    if (problems.empty()) return {};
    const InputProblem& first = problems.front();
    // The field has its label before it.
    const bool isOfThese = std::ranges::any_of(
        values, [&](const ParameterValue& value) { return value.parameter->key == first.key; });
    return isOfThese && !first.reason.arguments.empty() ? translated(first.reason.arguments.back())
                                                        : inWordsOfTheForm(first, scenario);
}

QString Document::contentsWith(const std::vector<ParameterValue>& values, ScenarioDocument& changed) const {
    ScenarioDocument with = contents();
    if (const QString problem = change(with.scenario, values); !problem.isEmpty()) return problem;
    with.text = writeScenario(with);
    changed = std::move(with);
    return {};
}

void Document::clear(const Parameter& parameter, int gesture) {
    Scenario changed = m_scenario;
    if (parameter.rules.clear) {
        parameter.rules.clear(changed);
    } else {
        // Only the diameter of a rod that was given by its area can have had no value before.
        const auto* last = dynamic_cast<const ScenarioEdit*>(m_undoStack.command(m_undoStack.index() - 1));
        if (!last || !last->isOf(keyOf(parameter), gesture)) return;
        changed = last->before();
    }
    push(std::move(changed), tr("clear %1").arg(parameterTitle(parameter, m_scenario)), keyOf(parameter),
         gesture);
}

bool Document::canHaveShape(PulseShape shape) const {
    Scenario changed = m_scenario;
    changed.pulse.shape = shape;
    return m_check(changed).empty();
}

void Document::setShape(PulseShape shape) {
    if (!canHaveShape(shape)) return;
    Scenario changed = m_scenario;
    changed.pulse.shape = shape;
    const std::string_view shapeName = name(shape);
    push(std::move(changed), tr("change the pulse shape to %1").arg(coreName(shapeName)));
}

void Document::setTitle(const QString& title) {
    Scenario changed = m_scenario;
    changed.title = title.toStdString();
    push(std::move(changed), tr("change the title"));
}

void Document::push(Scenario after, const QString& name, const QString& key, int gesture) {
    if (after != m_scenario) push(newEdit(std::move(after), key, gesture), name);
}

void Document::push(std::unique_ptr<ScenarioEdit> edit, const QString& name) {
    edit->setText(name);
    m_undoStack.push(edit.release());
}

// Pushes a step with its text, byte for byte.
void Document::pushContents(Scenario after, const std::string& text, const DesignSetup& design,
                            const QString& name) {
    ScenarioDocument contents{std::move(after), text, m_source.source, design};
    // Comments are no part of the scenario.
    const bool isSame = contents.scenario == m_scenario && design == m_design &&
                        writeScenario(contents) == writeScenario(this->contents());
    if (isSame) return;
    std::unique_ptr<ScenarioEdit> edit = newEdit(std::move(contents.scenario), {}, 0);
    edit->takeText(m_text, text);
    if (design != m_design) edit->takeDesign(m_design, design);
    push(std::move(edit), name);
}

std::unique_ptr<ScenarioEdit> Document::newEdit(Scenario after, const QString& key, int gesture) {
    // Points that were read again and are the same need no memory of their own in the history.
    if (after.pulse.tablePoints == m_scenario.pulse.tablePoints)
        after.pulse.tablePoints = m_scenario.pulse.tablePoints;
    nameChanged(after);
    return std::make_unique<ScenarioEdit>(
        m_scenario, [this] { announceChange(); }, std::move(after), key, gesture);
}

void Document::setDesign(const DesignSetup& design) {
    if (design == m_design) return;
    auto edit = std::make_unique<DesignEdit>(
        m_design,
        [this] {
            announceDesign();
            emit stateChanged();
        },
        design);
    edit->setText(tr("change the design study"));
    m_undoStack.push(edit.release());
}

void Document::announceDesign() {
    if (m_design == m_designTold) return;
    m_designTold = m_design;
    emit designChanged();
}

void Document::announceChange() {
    emit scenarioChanged();
    announceDesign();
    emit stateChanged();
}

void Document::take(ScenarioDocument source, const QString& path, const QString& origin) {
    m_source = std::move(source);
    m_text = m_source.text;
    m_example.reset();
    m_path = path;
    m_origin = origin;
    m_undoStack.clear();
    m_undoStack.setClean();  // an empty stack ignores clear(), and may have been marked unsaved
    emit replaced();
    m_scenario = m_source.scenario;
    m_design = m_source.design;
    announceChange();
    emit tableRead();
}

void Document::start() {
    take({}, {}, {});
}

QString Document::startFrom(std::string_view text, const QString& name) {
    try {
        take(parseScenario(text, name.toStdString()), {}, {});
    } catch (const ScenarioError& error) {
        return translated(error);
    }
    m_example = m_scenario;
    return {};
}

QString Document::open(const QString& path) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    try {
        const std::string native = nativePath(absolute);
        ScenarioInput input = loadInput(native);
        // Saving writes a scenario, which must not replace a result.
        const QString toSave = input.isResult ? QString() : absolute;
        const Message changes = changesSentence(input.version, input.document.scenario);
        take(std::move(input.document), toSave, absolute);
        if (!changes.isEmpty()) emit olderResultOpened(translated(changes));
    } catch (const ScenarioError& error) {
        return translated(error);
    }
    return {};
}

QString Document::reload() {
    try {
        ScenarioDocument source = loadScenario(nativePath(m_path));
        m_example.reset();  // the file has words of its own
        pushContents(source.scenario, source.text, source.design, tr("reload the file"));
        m_source = std::move(source);
    } catch (const ScenarioError& error) {
        return translated(error);
    }
    m_undoStack.setClean();
    emit tableRead();
    emit stateChanged();
    return {};
}

QString Document::restore(const std::string& text, const QString& origin, bool isUnsaved) {
    const std::string source = origin.isEmpty() ? std::string() : nativePath(origin);
    try {
        take(parseScenario(text, source), {}, origin);
    } catch (const ScenarioError& error) {
        return translated(error);
    }
    if (isUnsaved) markUnsaved();
    return {};
}

QString Document::restore(const std::string& text, const QString& path, const std::string& saved) {
    const std::string source = nativePath(path);
    try {
        ScenarioDocument unsaved = parseScenario(text, source);
        take(parseScenario(saved, source), path, path);
        pushContents(std::move(unsaved.scenario), unsaved.text, unsaved.design,
                     tr("restore the unsaved changes"));
    } catch (const ScenarioError& error) {
        return translated(error);
    }
    return {};
}

void Document::markUnsaved() {
    m_undoStack.resetClean();
    emit stateChanged();
}

QString Document::applyPreset(const Preset& preset) {
    // A menu that is open stays so when the scenario is replaced, by an undo or another file.
    if (preset.kind == PresetKind::rod && hasUnits(m_scenario) &&
        !partProblem(PresetPart::rod, m_scenario).isEmpty())
        return tr("A preset of a rod is for uniform rods, and this scenario is a drill string.");
    if (!isForced(m_scenario) && preset.kind == PresetKind::hammer)
        return tr("A preset of a blow is a force, and this string is struck by the sections of its hammer.");
    if (!hasUnits(m_scenario))
        return tr("A preset has physical units, and this scenario is given by its dimensionless groups.");
    Scenario changed = withPreset(m_scenario, preset);
    const std::vector<InputProblem> problems = m_check(changed);
    if (!problems.empty()) return inWordsOfTheForm(preset.name, problems, changed);
    if (changed == m_scenario) return {};
    try {
        const std::string text = writeWithPreset({changed, m_text, m_source.source, m_design}, preset);
        emit presetTaken();
        pushContents(std::move(changed), text, m_design, tr("take the preset %1").arg(coreText(preset.name)));
    } catch (const ScenarioError& error) {
        return translated(error);
    }
    return {};
}

QString Document::useScenario(const Scenario& scenario, const QString& step) {
    const std::vector<InputProblem> problems = m_check(scenario);
    if (!problems.empty()) return inWordsOfTheForm(scenario.title, problems, scenario);
    push(scenario, step);
    return {};
}

QString Document::useContents(const ScenarioDocument& contents, const QString& step) {
    std::vector<InputProblem> problems = m_check(contents.scenario);
    if (!problems.empty())
        return translated(ScenarioError(ScenarioError::Kind::invalid, contents.source, std::move(problems)));
    Scenario after = contents.scenario;
    after.pulse.tableFile =
        tableSeenFrom(m_origin, QFile::decodeName(contents.source.c_str()), after.pulse.tableFile);
    pushContents(std::move(after), contents.text, contents.design, step);
    return {};
}

QString Document::useTable(const QString& path) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    const QString name =
        m_origin.isEmpty() ? absolute : QFileInfo(m_origin).absoluteDir().relativeFilePath(absolute);
    return takeTable(absolute, nativePath(name),
                     tr("take the hammer blow from %1").arg(QFileInfo(path).fileName()));
}

QString Document::reloadTable() {
    return takeTable(tablePath(), m_scenario.pulse.tableFile, tr("reload the table of the hammer blow"));
}

QString Document::tablePath() const {
    const QString name = QFile::decodeName(m_scenario.pulse.tableFile.c_str());
    if (name.isEmpty()) return {};
    return QFileInfo(m_origin.isEmpty() ? QDir() : QFileInfo(m_origin).absoluteDir(), name)
        .absoluteFilePath();
}

QString Document::takeTable(const QString& path, const std::string& name, const QString& step) {
    if (!isForced(m_scenario))
        return tr("This string is struck by the sections of its hammer, not by a force from a table.");
    PulseTable table = readPulseTable(nativePath(path), nativePath(path), m_scenario.form);
    std::vector<InputProblem> problems = std::move(table.problems);
    Scenario changed = m_scenario;
    changed.pulse.shape = PulseShape::table;
    changed.pulse.tablePoints = std::move(table.points);
    changed.pulse.tableFile = name;
    if (problems.empty()) problems = m_check(changed);
    if (!problems.empty())
        return translated(ScenarioError(ScenarioError::Kind::invalid, nativePath(path), std::move(problems)));
    push(std::move(changed), step);
    emit tableRead();
    return {};
}

// The points of a table are in a file named relative to the scenario: saved elsewhere, the name must follow.
bool Document::keepTableInReach(const QString& path) {
    Scenario changed = m_scenario;
    changed.pulse.tableFile = tableSeenFrom(path, m_origin, m_scenario.pulse.tableFile);
    if (changed.pulse.tableFile == m_scenario.pulse.tableFile) return false;
    push(std::move(changed), tr("follow the table of the pulse"));
    return true;
}

QString Document::save(const QString& path) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    const bool tableMoved = keepTableInReach(absolute);
    const auto failed = [&](const QString& reason) {
        if (tableMoved) m_undoStack.undo();
        return tr("%1: cannot be saved: %2. Your changes are still here: save under another name or in "
                  "another folder.")
            .arg(QDir::toNativeSeparators(absolute), reason);
    };
    QByteArray bytes;
    try {
        bytes = text();
    } catch (const ScenarioError& error) {
        return failed(translated(error));
    }
    if (const QString reason = replaceFile(absolute, bytes); !reason.isEmpty()) return failed(reason);
    // The text it came from stays: the bytes of every step of the history are what they were before.
    m_source = {m_scenario, bytes.toStdString(), nativePath(absolute), m_design};
    m_path = m_origin = absolute;
    m_undoStack.setClean();
    emit saved();
    emit stateChanged();
    return {};
}

}  // namespace drillwave
