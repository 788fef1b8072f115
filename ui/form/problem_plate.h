// SPDX-License-Identifier: GPL-3.0-or-later
// Why a field does not take its text, on a plate over what is below it: no other row moves for it.
#pragma once

#include <QLabel>

namespace drillwave {

/// Hidden at first. It lies in the scrolled widget of its field, over other rows, and lets the mouse through.
class ProblemPlate : public QLabel {
    Q_OBJECT

  public:
    explicit ProblemPlate(QWidget* field);

    void say(const QString& text);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void place();

    QWidget* m_field;
};

}  // namespace drillwave
