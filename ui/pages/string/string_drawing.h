// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing of hammer and string to scale, coloured by the largest stresses of each section.
#pragma once

#include <QWidget>
#include <optional>

#include "ui/pages/string/string_model.h"
#include "ui/plot/colour_scale.h"

namespace drillwave {

/// Drawing of hammer and drill string, from the rear of the hammer to the rock. Diameters are exaggerated by
/// a factor that the drawing states. The upper half of a section has the colour of its largest tension, the
/// lower half that of its largest compression. A click, or the keys Left, Right, Home and End, selects a
/// section.
class StringDrawing : public QWidget {
    Q_OBJECT

  public:
    /// Creates the drawing. Model and units must outlive it.
    StringDrawing(const StringModel& model, const UnitChoice& units, QWidget* parent = nullptr);

    /// Marks the sections that belong to a row of the table (from 0); −1 removes the mark.
    void setRow(int row);
    /// Returns the index of the section at a point [px], counted from 0 at the rear of the hammer. Empty
    /// outside hammer and string.
    std::optional<std::size_t> sectionAt(QPointF point) const;
    /// Returns the rectangle [px] of a section given by its index, counted from 0 at the rear of the hammer.
    QRectF sectionRect(std::size_t section) const;
    /// Returns a text for a section: its name, impedance, and largest stresses with place and time.
    QString textOf(std::size_t section) const;
    /// Returns the scale of diameters divided by the scale of lengths; 0 if nothing is drawn.
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
