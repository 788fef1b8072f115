// SPDX-License-Identifier: GPL-3.0-or-later
// Files dropped onto the window.
#pragma once

#include <QObject>

class QDropEvent;
class QWidget;

namespace drillwave {

/// Takes files dropped anywhere onto a window, also onto fields that would take their names as text.
class FileDrop : public QObject {
    Q_OBJECT

  public:
    explicit FileDrop(QWidget* window);

  signals:
    /// Paths of local files, at least one; sent when the program they come from has been let go.
    void dropped(const QStringList& paths);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool take(QDropEvent& event);

    QWidget* m_window;
};

}  // namespace drillwave
