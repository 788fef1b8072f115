// SPDX-License-Identifier: GPL-3.0-or-later
// One undo step of the set-up of the design study of a document.
#pragma once

#include <QUndoCommand>
#include <functional>
#include <string>

#include "core/model/design_setup.h"

namespace drillwave {

/// Exchanges the set-up for another one and back. Consecutive edits of one item melt into one step.
class DesignEdit : public QUndoCommand {
  public:
    /// `current`, and what `changed` calls after each exchange, must outlive this.
    DesignEdit(DesignSetup& current, std::function<void()> changed, DesignSetup after);

    void undo() override { exchange(); }
    void redo() override { exchange(); }
    int id() const override { return m_item.empty() ? -1 : 2; }  // 1: ScenarioEdit
    bool mergeWith(const QUndoCommand* other) override;

  private:
    void exchange();

    DesignSetup& m_current;
    std::function<void()> m_changed;
    DesignSetup m_other;
    std::string m_item;  // the only one that changes, "uncertain 2"; else empty
};

}  // namespace drillwave
