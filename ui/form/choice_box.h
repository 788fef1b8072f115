// SPDX-License-Identifier: GPL-3.0-or-later
// A combo box for a panel that scrolls.
#pragma once

#include <QComboBox>

namespace drillwave {

/// Takes the wheel only while it has the focus, so that the panel scrolls over it.
class ChoiceBox : public QComboBox {
    Q_OBJECT

  public:
    explicit ChoiceBox(QWidget* parent = nullptr);

  protected:
    void wheelEvent(QWheelEvent* event) override;
};

}  // namespace drillwave
