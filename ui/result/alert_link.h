// SPDX-License-Identifier: GPL-3.0-or-later
// How many alerts there are, from where their list may be out of sight.
#pragma once

#include <QToolButton>

namespace drillwave {

class AlertList;

/// "⚠ 2 alerts": a click leads to the list, the tooltip has its texts.
class AlertLink : public QToolButton {
    Q_OBJECT

  public:
    /// What it does where the list has nothing to tell: a row that stays says so, others go.
    enum class WithoutAny { said, hidden };

    /// Follows a list that lives as long.
    AlertLink(const AlertList& list, WithoutAny withoutAny, QWidget* parent = nullptr);

  private:
    void present();

    const AlertList& m_list;
    WithoutAny m_withoutAny;
};

}  // namespace drillwave
