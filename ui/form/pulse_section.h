// SPDX-License-Identifier: GPL-3.0-or-later
// Form rows of the hammer force: its shape, its plot, and the table from which it may be read.
#pragma once

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/document/document.h"
#include "ui/form/choice_box.h"
#include "ui/form/pulse_preview.h"
#include "ui/form/quantity_field.h"
#include "ui/questions/questions.h"

namespace drillwave {

/// Form rows of the hammer force that are not single parameters: its shape, its plot and its table of
/// measured forces.
class PulseSection : public QObject {
    Q_OBJECT

  public:
    /// Adds the rows at the end of `grid`. Document and questions must outlive this object.
    PulseSection(Document& document, Questions& questions, QGridLayout* grid, QWidget* parent);

    /// Choice whether to check again which pulse shapes the scenario permits (`asked`), or to use the result
    /// of the last check (`asBefore`). The check validates the scenario once for each shape.
    enum class Shapes { asked, asBefore };
    void present(const Scenario& scenario, Shapes shapes);

  signals:
    /// Emitted when the user asks to import a measured hammer force.
    void importRequested();

  private:
    void addShape(QGridLayout* grid, QWidget* parent);
    void addTable(QGridLayout* grid, QWidget* parent);
    void addImpulse(QGridLayout* grid, QWidget* parent);
    void showShape();
    void showTable(const Scenario& scenario);
    void chooseShape(PulseShape shape);
    void chooseTable();
    QString offerImpulse(double impulse);
    void scale();
    void tellIfFailed(const QString& problem);

    Document& m_document;
    Questions& m_questions;
    ChoiceBox* m_shape = nullptr;
    PulsePreview* m_preview = nullptr;
    QWidget* m_table = nullptr;
    QLabel* m_tableText = nullptr;
    QPushButton* m_reload = nullptr;
    QLabel* m_impulseLabel = nullptr;
    QuantityField* m_impulse = nullptr;  // impulse of the table [N s]; another value scales its forces
    std::optional<double> m_wanted;      // impulse entered but not yet applied [N s]
};

}  // namespace drillwave
