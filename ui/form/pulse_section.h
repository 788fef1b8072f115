// SPDX-License-Identifier: GPL-3.0-or-later
// The hammer blow's own rows: its shape, its drawing, and the table it may be from.
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

/// Its widgets live in the grid of the section.
class PulseSection : public QObject {
    Q_OBJECT

  public:
    /// Fills the lowest rows of `grid`. Document and questions must outlive it.
    PulseSection(Document& document, Questions& questions, QGridLayout* grid, QWidget* parent);

    /// Whether to check again which shapes the scenario can have: each shape needs a check of a scenario.
    enum class Shapes { asked, asBefore };
    void present(const Scenario& scenario, Shapes shapes);

  signals:
    /// The user wants to import a measured blow.
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
    QuantityField* m_impulse = nullptr;  // of a table
    std::optional<double> m_wanted;      // impulse that was given and not taken yet [N s]
};

}  // namespace drillwave
