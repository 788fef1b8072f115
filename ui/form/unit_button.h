// SPDX-License-Identifier: GPL-3.0-or-later
// A flat button that shows a unit and opens the menu of the others.
#pragma once

#include <QToolButton>

namespace drillwave {

class UnitButton : public QToolButton {
    Q_OBJECT

  public:
    explicit UnitButton(QWidget* parent = nullptr);

    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace drillwave
