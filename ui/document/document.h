// SPDX-License-Identifier: GPL-3.0-or-later
// Scenario being edited, with its file, undo history, unsaved changes and units.
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

/// Parameter with the value to set it to, in SI units.
struct ParameterValue {
    KeptParameter parameter;
    double si;
};

/// Returns a value with its unit for the names of undo steps: "9.5 kN". `si` is in SI units.
QString shownValue(const Parameter& parameter, double si);

class ScenarioEdit;

/// Document of the window: a valid scenario with its file and undo history. Edits that would make the
/// scenario invalid are refused.
class Document : public QObject {
    Q_OBJECT

  public:
    /// Function that returns all errors of a scenario; empty for a valid one.
    using Check = std::function<std::vector<InputProblem>(const Scenario&)>;

    explicit Document(QObject* parent = nullptr, Check check = validate);

    const Scenario& scenario() const { return m_scenario; }
    /// Returns the settings of the design study (search for the best design), which are saved in the scenario
    /// file. Empty until the user makes some.
    const DesignSetup& design() const { return m_design; }
    /// Replaces the settings of the design study, as one undo step. Does nothing if they are equal.
    void setDesign(const DesignSetup& design);
    QUndoStack& undoStack() { return m_undoStack; }
    /// Returns the choice of units for all input fields and results in the window.
    UnitChoice& units() { return m_units; }
    const UnitChoice& units() const { return m_units; }
    /// Returns the path of the scenario file, to which saving writes; empty if there is none.
    const QString& path() const { return m_path; }
    /// Returns the path of the file from which the scenario was read; empty if there is none. It may be a
    /// file of results, which saving never overwrites; see path().
    const QString& origin() const { return m_origin; }
    /// Returns a path to suggest for saving: that of the scenario file, else a .yaml file beside the file
    /// from which the scenario was read. A new scenario gets a file name made from its title.
    QString suggestedPath() const;
    /// Returns the title of the scenario, or else the name of its file, or else "Untitled".
    QString displayName() const;
    /// Returns true if the scenario or the settings of its design study differ from the file. Undo steps that
    /// do not affect the file are ignored.
    bool isModified() const;
    /// Returns true if the scenario differs from its file; settings of the design study are ignored.
    bool isScenarioModified() const;
    /// Returns the bytes that saving would write. Throws ScenarioError if they exceed the size limit of
    /// scenario files.
    QByteArray text() const;
    /// Returns the present scenario with the text from which it was read; saving keeps comments and layout of
    /// that text.
    ScenarioDocument contents() const;
    /// Returns true if the scenario is a built-in example whose values have been changed. Its title is then
    /// marked as changed. Saving omits the comment at the top of its text, which describes the original
    /// values.
    bool isChangedExample() const;
    /// Sets `changed` to a copy of the scenario with other values, which are set in this order. It contains
    /// the text that saving the copy would write. Leaves the document unchanged. Returns the reason on
    /// failure, else an empty text. Throws ScenarioError if the text exceeds the size limit of scenario
    /// files.
    QString contentsWith(const std::vector<ParameterValue>& values, ScenarioDocument& changed) const;
    /// Returns the scenario and its text as last read from the file or written to it, without later edits.
    const ScenarioDocument& source() const { return m_source; }
    const std::string& savedText() const { return m_source.text; }

    /// Returns a new number for a gesture: a group of edits that form one undo step, such as those of a drag.
    int newGesture() { return ++m_gestures; }
    /// Sets a parameter to the value `si` (SI units) as one undo step. Edits of one parameter with the same
    /// number `gesture`, such as those of a drag, are merged. Returns why the value is refused; empty if it
    /// was set.
    QString assign(const Parameter& parameter, double si, int gesture);
    /// Sets several parameters in this order as one undo step, such as the two parameters of a clicked point
    /// of a map. Requires at least one parameter, each only once. Returns why a value is refused; empty if
    /// all were set.
    QString assign(const std::vector<ParameterValue>& values, int gesture);
    /// Resets an optional parameter to "not given". Any other parameter gets the value that it had before the
    /// edits with the number `gesture`. Nothing happens if the last edit is not one of these.
    void clear(const Parameter& parameter, int gesture);
    /// Returns true if the scenario would be valid with this shape of the hammer force. A table, for example,
    /// needs points.
    bool canHaveShape(PulseShape shape) const;
    void setShape(PulseShape shape);
    void setTitle(const QString& title);
    /// Sets the values of a preset as one undo step. The text of the scenario gets their sources as comments.
    /// Returns the reason on failure, which leaves the document unchanged, else an empty text.
    QString applyPreset(const Preset& preset);
    /// Replaces the scenario as one undo step; `step` is the step's name. Returns the reason on failure,
    /// which leaves the document unchanged, else an empty text.
    QString useScenario(const Scenario& scenario, const QString& step);
    /// Replaces the scenario and its text, byte for byte, as one undo step; `step` is the step's name. If the
    /// hammer force is in a CSV file, its name is converted to be relative to this document's folder. Returns
    /// the reason on failure, which leaves the document unchanged, else an empty text.
    QString useContents(const ScenarioDocument& contents, const QString& step);
    /// Reads the hammer force from a CSV file of times and forces, as one undo step. Returns the reasons on
    /// failure, one per line, which leaves the document unchanged, else an empty text.
    QString useTable(const QString& path);
    /// Reads the CSV file of the hammer force again, as one undo step. Returns the reasons on failure, one
    /// per line, else an empty text. Requires that tablePath() is not empty.
    QString reloadTable();
    /// Returns the path of the CSV file from which the hammer force is read. Empty if the hammer force is not
    /// read from a file.
    QString tablePath() const;

    /// Starts a new scenario with the default values, without a file.
    void start();
    /// Replaces the scenario by one that is built into the program, such as an example; the document then has
    /// no file. `text` is its YAML text; `name` stands for a file name in messages. Returns the reasons on
    /// failure, one per line, else an empty text.
    QString startFrom(std::string_view text, const QString& name);
    /// Opens a scenario file, or the scenario stored in a file of results. For a file of results, path() is
    /// empty, so that saving never overwrites it. Returns the reasons on failure, one per line, which leaves
    /// the document unchanged, else an empty text.
    QString open(const QString& path);
    /// Reads the scenario file again, as one undo step, for example after another program has changed it.
    /// Returns the reasons on failure, which leaves the document unchanged, else an empty text.
    QString reload();
    /// Restores a scenario that was never saved, so that it has no file of its own. `text` is its YAML text;
    /// `origin` is the file from which it was read, and may be empty. If `isUnsaved`, the document counts as
    /// modified. Returns the reasons on failure, one per line, which leaves the document unchanged, else an
    /// empty text.
    QString restore(const std::string& text, const QString& origin, bool isUnsaved = true);
    /// Restores unsaved changes after a crash. `text` is the changed scenario, and `saved` the contents of
    /// its file `path`, to which undo leads back. Returns the reasons on failure, one per line, else an empty
    /// text.
    QString restore(const std::string& text, const QString& path, const std::string& saved);
    /// Marks the scenario as modified although the user has not edited it, because its file was changed or
    /// deleted by others.
    void markUnsaved();
    /// Writes the scenario file, completely or not at all. Returns the reason on failure, which leaves the
    /// document unchanged, else an empty text.
    QString save(const QString& path);

  signals:
    /// Emitted before another scenario, with its own file and history, replaces the present one.
    void replaced();
    /// Emitted when a result file of an older version of the program is opened; `changes` says in a sentence
    /// which of its numbers differ now.
    void olderResultOpened(const QString& changes);
    /// Emitted when the scenario was written to its file, whose path may have changed.
    void saved();
    void scenarioChanged();
    /// Emitted when the settings of the design study have changed. The scenario may have changed with them,
    /// which is reported first.
    void designChanged();
    /// Emitted after the hammer force was read from its CSV file, if it has one. This happens when a scenario
    /// is opened, its file is read again or the CSV file is read. It follows scenarioChanged().
    void tableRead();
    /// Emitted just before a preset (a set of stored values, such as those of a rod) changes the scenario.
    void presetTaken();
    /// Emitted when path, title or modified state may have changed.
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
    DesignSetup m_designTold;   // settings for which designChanged() was last emitted
    ScenarioDocument m_source;  // scenario and text as last read or written
    // Text that saving updates with as few changes as possible; it changes only with undo steps.
    std::string m_text;
    std::optional<Scenario> m_example;  // built-in example from which it was started
    QString m_path;
    QString m_origin;  // file from which names of other files are relative
    QUndoStack m_undoStack;
    UnitChoice m_units;
    int m_gestures = 0;
};

}  // namespace drillwave
