// SPDX-License-Identifier: GPL-3.0-or-later
// Dialog that asks for format, size and resolution of a picture.
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
    double dpi = 300;  ///< resolution [1/in]; used only for PNG

    /// Returns the size of a PNG picture [px].
    QSize pixels() const;
    /// Returns why no picture with this format, size and resolution can be made; empty if it can.
    QString problem() const;
};

/// Returns format, size and resolution that the user chose last. Before the first choice it returns a default
/// for a picture with this ratio of width to height.
PictureChoice rememberedPictureChoice(double aspectRatio);
void remember(const PictureChoice& choice);

/// Dialog for format, size and resolution of a picture. It can be accepted only if such a picture can be
/// made; otherwise it shows why not.
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
