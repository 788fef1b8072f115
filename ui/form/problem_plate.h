// SPDX-License-Identifier: GPL-3.0-or-later
// Label that shows why a field refuses its text. It covers the rows below instead of moving them.
#pragma once

#include <QLabel>

namespace drillwave {

/// Label that says why the text of an input field is invalid. It is drawn over the rows below the field, or
/// above the field if there is no room below. It is hidden until say() is called, and does not react to the
/// mouse.
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
