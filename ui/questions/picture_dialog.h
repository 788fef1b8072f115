// SPDX-License-Identifier: GPL-3.0-or-later
// Asks for format, size and resolution of a picture.
#pragma once

#include <QDialog>

#include "ui/questions/picture_choice.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace drillwave {

/// Cannot be accepted while its choice cannot be made; says why.
class PictureDialog : public QDialog {
    Q_OBJECT

  public:
    PictureDialog(const PictureChoice& before, QWidget* parent);

    PictureChoice choice() const;

  private:
    QDoubleSpinBox* addNumber(const char* name, const QString& unit, double value);
    void check();

    QComboBox* m_format;
    QDoubleSpinBox* m_width;
    QDoubleSpinBox* m_height;
    QDoubleSpinBox* m_dpi;
    QLabel* m_remark;
    QPushButton* m_accept;
};

}  // namespace drillwave
