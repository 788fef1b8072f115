// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/unfocused_wheel.h"

#include <QEvent>
#include <QWidget>

namespace drillwave {
namespace {

class WheelFilter : public QObject {
  public:
    explicit WheelFilter(QWidget& field) : QObject(&field) { field.installEventFilter(this); }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::Wheel || static_cast<QWidget*>(watched)->hasFocus()) return false;
        event->ignore();
        return true;
    }
};

}  // namespace

void ignoreUnfocusedWheel(QWidget& field) {
    field.setFocusPolicy(Qt::StrongFocus);
    new WheelFilter(field);
}

}  // namespace drillwave
