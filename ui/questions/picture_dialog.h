// SPDX-License-Identifier: GPL-3.0-or-later
// Asks for format, size and resolution of a picture.
#pragma once

#include <QDialog>
#include <QSize>
#include <QString>

#include "ui/plot/plot_rendering.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace drillwave {

// Format, size and resolution of a picture to be saved.

struct PictureChoice {
    QString format = QStringLiteral("png");  ///< one of plotFormats()
    Millimetres size{180, 120};
    double dpi = 300;  ///< counts for PNG only

    /// Pixels of a PNG.
    QSize pixels() const;
    /// Why no such picture can be made; empty when it can.
    QString problem() const;
};

/// The choice made last, or one for a picture of that width/height.
PictureChoice rememberedPictureChoice(double aspectRatio);
void remember(const PictureChoice& choice);

/// Cannot be accepted while its choice is impossible; shows why.
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
