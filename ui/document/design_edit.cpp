// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/design_edit.h"

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
