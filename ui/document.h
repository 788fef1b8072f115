// The scenario being edited: its file, its history of edits, and what has not been saved yet.
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>

#include "core/file/scenario_file.h"
#include "core/model/parameter.h"

namespace drillwave {

/// Always holds a scenario that validate() finds nothing wrong with; edits that would spoil it are refused.
class Document : public QObject {
    Q_OBJECT

  public:
    explicit Document(QObject* parent = nullptr);

    const Scenario& scenario() const { return m_scenario; }
    QUndoStack& undoStack() { return m_undoStack; }
    /// The file it was read from or saved to last; empty for a new one.
    const QString& path() const { return m_path; }
    /// Title of the scenario, else the name of its file, else "Untitled".
    QString displayName() const;
    bool isModified() const { return !m_undoStack.isClean(); }
    /// The bytes that saving would write.
    QByteArray text() const;

    /// Why a parameter cannot take a value (SI); empty when it can.
    QString whyNot(const Parameter& parameter, double si) const;
    /// Sets a parameter (SI) as one undo step; edits of one parameter with the same `gesture` are one step.
    void assign(const Parameter& parameter, double si, int gesture);
    /// Takes an optional parameter back to "not given".
    void clear(const Parameter& parameter, int gesture);
    /// Whether the scenario would be valid with that shape (a table needs points).
    bool canHaveShape(PulseShape shape) const;
    void setShape(PulseShape shape);
    void setTitle(const QString& title);

    /// A new scenario with the default values.
    void start();
    /// A scenario from text, without a file; `name` names it in messages. Returns why not, line by line.
    QString startFrom(std::string_view text, const QString& name);
    /// Replaces the scenario by that of a file. Returns why not, line by line; then nothing has changed.
    QString open(const QString& path);
    /// Writes the file whole or not at all. Returns why not; then nothing has changed.
    QString save(const QString& path);

  signals:
    void scenarioChanged();
    /// Path, title or modified state may have changed.
    void stateChanged();

  private:
    class Edit;
    void push(Scenario after, const QString& name, const QString& key = {}, int gesture = 0);
    void setScenario(const Scenario& scenario);
    void take(ScenarioDocument source, const QString& path);
    bool keepTableInReach(const QString& path);

    Scenario m_scenario;
    ScenarioDocument m_source;  // as last read or written: what saving changes as little as possible
    QString m_path;
    QUndoStack m_undoStack;
};

}  // namespace drillwave
