// SPDX-License-Identifier: GPL-3.0-or-later
// The scenario being edited: its file, its history of edits, what has not been saved yet, and its units.
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/model/parameter.h"
#include "core/model/preset.h"
#include "core/model/validation.h"
#include "core/yaml/scenario_file.h"
#include "ui/text/unit_choice.h"

namespace drillwave {

/// A parameter and the value to set it to.
struct ParameterValue {
    KeptParameter parameter;
    double si;
};

/// Formats a value with its unit for the steps of the history: "9.5 kN".
QString shownValue(const Parameter& parameter, double si);

class ScenarioEdit;

/// Always holds a scenario that the check finds nothing wrong with; edits that would spoil it are refused.
class Document : public QObject {
    Q_OBJECT

  public:
    /// Everything wrong with a scenario.
    using Check = std::function<std::vector<InputProblem>(const Scenario&)>;

    explicit Document(QObject* parent = nullptr, Check check = validate);

    const Scenario& scenario() const { return m_scenario; }
    /// The set-up of its design study, saved in its file; empty until the user makes one.
    const DesignSetup& design() const { return m_design; }
    /// Takes another set-up as one undo step.
    void setDesign(const DesignSetup& design);
    QUndoStack& undoStack() { return m_undoStack; }
    /// The units of all fields and results.
    UnitChoice& units() { return m_units; }
    const UnitChoice& units() const { return m_units; }
    /// The file it was read from or saved to last, which saving writes; empty where there is none.
    const QString& path() const { return m_path; }
    /// The file that it came from, even if saving does not write that; empty where there is none.
    const QString& origin() const { return m_origin; }
    /// Proposes a file to save to: path(), else a scenario file next to the file that it was read from.
    QString suggestedPath() const;
    /// Title of the scenario, else the name of its file, else "Untitled".
    QString displayName() const;
    /// Whether the scenario is another one than in its file; other steps of the history do not count.
    bool isModified() const;
    /// Whether the part that all commands read is modified: the set-up of the design study does not count.
    bool isScenarioModified() const;
    /// The bytes that saving would write. Throws ScenarioError where they would be more than a file may have.
    QByteArray text() const;
    /// Returns the present scenario with the text it came from, from which its bytes are made.
    ScenarioDocument contents() const;
    /// Whether it began as an example and has changed since: the example's remarks on its values, in the
    /// title and in the comment at its head, are dropped then.
    bool isChangedExample() const;
    /// The scenario with other values of parameters, set in that order, and its text, as saving would write
    /// it. Changes nothing here; returns why not. Throws ScenarioError as text() does.
    QString contentsWith(const std::vector<ParameterValue>& values, ScenarioDocument& changed) const;
    /// The scenario and its bytes as last read or written.
    const ScenarioDocument& source() const { return m_source; }
    const std::string& savedText() const { return m_source.text; }

    /// Returns a number for a new gesture. Edits that belong together share one, for example those of a drag.
    int newGesture() { return ++m_gestures; }
    /// Sets a parameter (SI) as one undo step; edits of one parameter with the same `gesture` are one step.
    /// Returns why it cannot take that value, empty when it has.
    QString assign(const Parameter& parameter, double si, int gesture);
    /// Sets several parameters in this order, such as both axes of a map. Requires at least one parameter,
    /// each of them once.
    QString assign(const std::vector<ParameterValue>& values, int gesture);
    /// Takes an optional parameter back to "not given", any other to what it was before the gesture.
    void clear(const Parameter& parameter, int gesture);
    /// Whether the scenario would be valid with that shape (a table needs points).
    bool canHaveShape(PulseShape shape) const;
    void setShape(PulseShape shape);
    void setTitle(const QString& title);
    /// Takes values and sources of a preset as one undo step. Returns why not; then nothing has changed.
    QString applyPreset(const Preset& preset);
    /// Takes another scenario as one undo step of that name. Returns why not; then nothing has changed.
    QString useScenario(const Scenario& scenario, const QString& step);
    /// Takes another scenario with its text, byte for byte, as one undo step of that name. A table that is
    /// named relative to another folder is named relative to this scenario's. Returns why not; then nothing
    /// has changed.
    QString useContents(const ScenarioDocument& contents, const QString& step);
    /// Takes the hammer blow from a CSV file of times and forces, as one undo step. Returns why not, line by
    /// line; then nothing has changed.
    QString useTable(const QString& path);
    /// Reads the CSV file of the hammer blow again, as useTable() does. Requires tablePath().
    QString reloadTable();
    /// The CSV file that the points of the hammer blow are from; empty when they are the scenario's own.
    QString tablePath() const;

    /// A new scenario with the default values.
    void start();
    /// A scenario from text, without a file; `name` names it in messages. Returns why not, line by line.
    QString startFrom(std::string_view text, const QString& name);
    /// Replaces the scenario by that of a file, or by the one that a CSV file of results begins with; that
    /// has no path(), so that saving never writes over results. Returns why not, line by line; then nothing
    /// has changed.
    QString open(const QString& path);
    /// Reads the file of the scenario again, as an undo step. Returns why not; then nothing has changed.
    QString reload();
    /// Replaces the scenario by one that was never saved, without a path(); `origin` is the file it was an
    /// edit of, or empty. Returns why not, line by line; then nothing has changed.
    QString restore(const std::string& text, const QString& origin, bool isUnsaved = true);
    /// Also sets the file it is saved to and the contents of that file, to which undo leads back.
    QString restore(const std::string& text, const QString& path, const std::string& saved);
    /// Counts as modified from now on, because its file differs or is gone.
    void markUnsaved();
    /// Writes the file whole or not at all. Returns why not; then nothing has changed.
    QString save(const QString& path);

  signals:
    /// Another scenario has taken the place of the one before, with its file and history.
    void replaced();
    /// A result of an older version has been opened: which of its numbers have changed, in a sentence.
    void olderResultOpened(const QString& changes);
    /// Written to its file, which may be another one than before.
    void saved();
    void scenarioChanged();
    /// The set-up of the design study is another one. The scenario may have changed before.
    void designChanged();
    /// The points of the hammer blow, if they have a tablePath(), were read from it just now. Emitted after
    /// scenarioChanged().
    void tableRead();
    /// A preset is about to change the scenario.
    void presetTaken();
    /// Path, title or modified state may have changed.
    void stateChanged();

  private:
    QString change(Scenario& scenario, const std::vector<ParameterValue>& values) const;
    void push(Scenario after, const QString& name, const QString& key = {}, int gesture = 0);
    void push(std::unique_ptr<ScenarioEdit> edit, const QString& name);
    void pushContents(Scenario after, const std::string& text, const DesignSetup& design,
                      const QString& name);
    std::unique_ptr<ScenarioEdit> newEdit(Scenario after, const QString& key, int gesture);
    void announceChange();
    void announceDesign();
    bool hasUnsaved(const std::function<bool(const QUndoCommand&)>& counts) const;
    void nameChanged(Scenario& after) const;
    void take(ScenarioDocument source, const QString& path, const QString& origin);
    QString takeTable(const QString& path, const std::string& name, const QString& step);
    bool keepTableInReach(const QString& path);

    Check m_check;
    Scenario m_scenario;
    DesignSetup m_design;
    DesignSetup m_designTold;   // what designChanged() was emitted for last
    ScenarioDocument m_source;  // as last read or written
    std::string m_text;         // what saving changes as little as possible; changes only with the history
    std::optional<Scenario> m_example;  // which it began as
    QString m_path;
    QString m_origin;  // what the names of other files are relative to
    QUndoStack m_undoStack;
    UnitChoice m_units;
    int m_gestures = 0;
};

}  // namespace drillwave
