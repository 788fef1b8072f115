// SPDX-License-Identifier: GPL-3.0-or-later
// A value that leads to where it is from, by mouse and keys.
#pragma once

#include <QLabel>

namespace drillwave {

/// Plain text that looks and works like a link.
class PlaceLink : public QLabel {
    Q_OBJECT

  public:
    explicit PlaceLink(QWidget* parent = nullptr);

  signals:
    void followed();

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace drillwave
