// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/scenario_edit.h"

#include <array>
#include <utility>
#include <vector>

namespace drillwave {

namespace {

/// The text that differs, of a list with as many items as the other; empty where it is not one text only.
std::string changedItem(const DesignSetup& one, const DesignSetup& other) {
    const std::array lists{std::pair("uncertain", &DesignSetup::uncertain),
                           std::pair("choose", &DesignSetup::choose), std::pair("aims", &DesignSetup::aims)};
    std::string item;
    DesignSetup adapted = one;
    for (const auto& [name, list] : lists) {
        const std::vector<std::string>&a = one.*list, &b = other.*list;
        if (a.size() != b.size()) return {};
        for (std::size_t i = 0; i < a.size(); ++i) {
            if (a[i] == b[i]) continue;
            if (!item.empty()) return {};
            item = name + (" " + std::to_string(i));
        }
        adapted.*list = b;
    }
    return adapted == other ? item : std::string();
}

}  // namespace

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

DesignEdit::DesignEdit(DesignSetup& current, std::function<void()> changed, DesignSetup after)
    : m_current(current),
      m_changed(std::move(changed)),
      m_other(std::move(after)),
      m_item(changedItem(current, m_other)) {}

void DesignEdit::exchange() {
    std::swap(m_current, m_other);
    m_changed();
}

bool DesignEdit::mergeWith(const QUndoCommand* other) {
    const auto* later = static_cast<const DesignEdit*>(other);
    if (later->m_item != m_item) return false;
    setObsolete(m_other == m_current);
    return true;
}

}  // namespace drillwave
