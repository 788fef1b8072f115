// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/scenario_edit.h"

#include <utility>

namespace drillwave {

ScenarioEdit::ScenarioEdit(Scenario& current, std::function<void()> changed, Scenario after, QString key,
                           int gesture)
    : m_current(current),
      m_changed(std::move(changed)),
      m_other(std::move(after)),
      m_key(std::move(key)),
      m_gesture(gesture) {}

void ScenarioEdit::takeText(std::string& current, std::string after) {
    m_currentText = &current;
    m_textBefore = current;
    m_textAfter = std::move(after);
}

void ScenarioEdit::takeDesign(DesignSetup& current, DesignSetup after) {
    m_currentDesign = &current;
    m_designBefore = current;
    m_designAfter = std::move(after);
}

void ScenarioEdit::exchange(const std::string& text, const DesignSetup& design) {
    std::swap(m_current, m_other);
    if (m_currentText) *m_currentText = text;
    if (m_currentDesign) *m_currentDesign = design;
    m_changed();
}

bool ScenarioEdit::mergeWith(const QUndoCommand* other) {
    const auto* later = static_cast<const ScenarioEdit*>(other);
    if (!later->isOf(m_key, m_gesture)) return false;
    setText(later->text());
    setObsolete(m_other == m_current);
    return true;
}

}  // namespace drillwave
