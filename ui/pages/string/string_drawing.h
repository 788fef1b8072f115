// SPDX-License-Identifier: GPL-3.0-or-later
// Hammer and string to scale, coloured by the largest stresses of each section.
#pragma once

#include <QWidget>
#include <optional>

#include "ui/pages/string/string_model.h"
#include "ui/plot/colour_scale.h"

namespace drillwave {

/// Lengths run from the rear of the hammer to the rock; diameters are exaggerated by a factor that the
/// drawing shows. The upper half of a section has the colour of its largest tension, the lower half that of
/// its largest compression. A click, and the keys Left, Right, Home and End, choose a section.
class StringDrawing : public QWidget {
    Q_OBJECT

  public:
    /// Model and units must outlive it.
    StringDrawing(const StringModel& model, const UnitChoice& units, QWidget* parent = nullptr);

    /// The row whose sections are marked; −1 for none.
    void setRow(int row);
    /// Returns the section of the chain below a point; nothing beside hammer and string.
    std::optional<std::size_t> sectionAt(QPointF point) const;
    /// Returns the rect of a section of the chain.
    QRectF sectionRect(std::size_t section) const;
    /// Describes a section: its name, impedance, and largest stresses with place and time.
    QString textOf(std::size_t section) const;
    /// Returns the factor of diameters over lengths; 0 if there is nothing to draw.
    double exaggeration() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  signals:
    void rowChosen(int row);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    double totalLength() const;
    double hammerLength() const;
    double largestDiameter() const;
    QRectF area() const;
    double wordsHeight() const;
    const ColourScale& colours() const;
    QColor colour(double stress) const;
    void drawSection(QPainter& painter, std::size_t section) const;
    void drawMarks(QPainter& painter) const;
    void drawRuler(QPainter& painter) const;
    void drawLegend(QPainter& painter) const;
    void choose(int row);

    const StringModel& m_model;
    const UnitChoice& m_units;
    int m_row = -1;
};

}  // namespace drillwave
