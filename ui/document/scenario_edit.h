// SPDX-License-Identifier: GPL-3.0-or-later
// Undo steps of a document: of its scenario, and of the settings of its design study.
#pragma once

#include <QString>
#include <QUndoCommand>
#include <functional>
#include <string>

#include "core/model/design_setup.h"
#include "core/model/scenario.h"

namespace drillwave {

/// Kind of an undo step, as QUndoCommand::id() returns it: only steps of the same kind are merged. Lists all
/// kinds of the undo stack of a document, so that no two share a number.
enum class UndoKind { scenario = 1, design, measured };

/// Undo step that changes the document's scenario by swapping it with a stored one, which avoids copies. Text
/// and design settings, if the step changes them too, are set from stored copies. Edits of the same parameter
/// within one gesture (such as a drag) are merged.
class ScenarioEdit : public QUndoCommand {
  public:
    /// Makes a step that changes `current` to `after`, and back on undo. It calls `changed` after each
    /// change. `current` must outlive the step. `key` names the edited parameter; a step with an empty key is
    /// never merged.
    ScenarioEdit(Scenario& current, std::function<void()> changed, Scenario after, QString key, int gesture);

    /// Returns the scenario before the edit. Requires that the edit is in effect, so that undo() has not been
    /// called or redo() followed.
    const Scenario& before() const { return m_other; }
    bool isOf(const QString& key, int gesture) const { return m_key == key && m_gesture == gesture; }

    /// Extends the step so that it also changes `current`, the YAML text of the scenario, to `after`. Undo
    /// restores the text that `current` has now. `current` must outlive this step.
    void takeText(std::string& current, std::string after);

    /// Extends the step so that it also changes `current`, the settings of the design study, to `after`. Undo
    /// restores the settings that `current` has now. `current` must outlive this step.
    void takeDesign(DesignSetup& current, DesignSetup after);

    void undo() override { exchange(m_textBefore, m_designBefore); }
    void redo() override { exchange(m_textAfter, m_designAfter); }
    int id() const override { return m_key.isEmpty() ? -1 : int(UndoKind::scenario); }
    bool mergeWith(const QUndoCommand* other) override;

  private:
    void exchange(const std::string& text, const DesignSetup& design);

    Scenario& m_current;
    std::function<void()> m_changed;
    Scenario m_other;
    std::string* m_currentText = nullptr;
    std::string m_textBefore;
    std::string m_textAfter;
    DesignSetup* m_currentDesign = nullptr;
    DesignSetup m_designBefore;
    DesignSetup m_designAfter;
    QString m_key;
    int m_gesture;
};

// Undo step of the settings of a document's design study.

/// Undo step that swaps the settings of the design study with stored ones. Consecutive edits of one list
/// item, such as an uncertain input, are merged into one step.
class DesignEdit : public QUndoCommand {
  public:
    /// Makes a step that changes `current` to `after`, and back on undo. It calls `changed` after each
    /// change. `current` must outlive the step.
    DesignEdit(DesignSetup& current, std::function<void()> changed, DesignSetup after);

    void undo() override { exchange(); }
    void redo() override { exchange(); }
    int id() const override { return m_item.empty() ? -1 : int(UndoKind::design); }
    bool mergeWith(const QUndoCommand* other) override;

  private:
    void exchange();

    DesignSetup& m_current;
    std::function<void()> m_changed;
    DesignSetup m_other;
    std::string m_item;  // the only list item that changes, "uncertain 2"; else empty
};

}  // namespace drillwave
