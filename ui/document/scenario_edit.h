// SPDX-License-Identifier: GPL-3.0-or-later
// One undo step of a document.
#pragma once

#include <QString>
#include <QUndoCommand>
#include <functional>
#include <string>

#include "core/model/design_setup.h"
#include "core/model/scenario.h"

namespace drillwave {

/// Kind of an undo step: QUndoCommand::id(), which merges steps of one kind only. All kinds of the undo stack
/// of a document are here, so that no two have one number.
enum class UndoKind { scenario = 1, design, measured };

/// Exchanges the scenario of a document for another one and back: it holds the one that is not shown, so that
/// nothing is copied. Texts it sets as they were, whatever has become of them since. Edits of the same
/// parameter within a gesture melt into one.
class ScenarioEdit : public QUndoCommand {
  public:
    /// `current` and the owner of `changed`, which is called after each exchange, must outlive this. An edit
    /// with an empty `key` merges with no other.
    ScenarioEdit(Scenario& current, std::function<void()> changed, Scenario after, QString key, int gesture);

    /// The scenario before the edit. Requires that it was done and not undone.
    const Scenario& before() const { return m_other; }
    bool isOf(const QString& key, int gesture) const { return m_key == key && m_gesture == gesture; }

    /// Sets the text that the scenario came from, too, and back to what it is now. `current` must outlive
    /// this.
    void takeText(std::string& current, std::string after);

    /// Sets the set-up of the design study, too, and back to what it is now. `current` must outlive this.
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

// One undo step of the set-up of the design study of a document.

/// Exchanges the set-up for another one and back. Consecutive edits of one item melt into one step.
class DesignEdit : public QUndoCommand {
  public:
    /// `current`, and what `changed` calls after each exchange, must outlive this.
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
    std::string m_item;  // the only one that changes, "uncertain 2"; else empty
};

}  // namespace drillwave
