// SPDX-License-Identifier: GPL-3.0-or-later
// What to look at in the example that is open.
#pragma once

#include <QAction>

#include "core/yaml/examples.h"
#include "ui/window/notice.h"

namespace drillwave {

class ExampleNote : public Notice {
    Q_OBJECT

  public:
    explicit ExampleNote(QWidget* parent = nullptr);

    /// Shows the explanation of an example.
    void explain(const Example& example);
    /// The example the program begins with: its explanation is not shown once the user has dismissed it.
    void explainFirst(const Example& example);
    /// The scenario is no longer that of the example, or is so again: the explanation may not fit its values.
    void setChanged(bool changed);
    /// Another scenario is open.
    void forget();
    /// Shows and hides the note; disabled where there is nothing to explain.
    QAction* action() const { return m_action; }

  private:
    void set(const Example& example);

    QAction* m_action;
    QString m_explanation;
    bool m_isFirst = false;
};

}  // namespace drillwave
