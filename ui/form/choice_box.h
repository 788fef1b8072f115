// SPDX-License-Identifier: GPL-3.0-or-later
// Combo box for a panel that scrolls.
#pragma once

#include <QComboBox>

namespace drillwave {

/// Combo box that reacts to the mouse wheel only while it has the focus, so that the wheel scrolls the panel.
/// Its list is as wide as its entries. A tooltip shows the chosen entry if it is cut off.
class ChoiceBox : public QComboBox {
    Q_OBJECT

  public:
    explicit ChoiceBox(QWidget* parent = nullptr);

    /// Makes the box as wide as the chosen text if there is room, for example in a row that wraps.
    void followText();
    QSize sizeHint() const override;
    void showPopup() override;

  protected:
    bool event(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

  private:
    int textWidth() const;
    bool isCut() const;

    bool m_followsText = false;
};

}  // namespace drillwave
