// SPDX-License-Identifier: GPL-3.0-or-later
// Dialog that converts a scenario of dimensionless groups into one in physical units (a rig).
#pragma once

#include <QDialog>

#include "core/model/form_conversion.h"
#include "ui/document/document.h"
#include "ui/document/preset_library.h"

class QLabel;
class QPushButton;

namespace drillwave {

class ChoiceBox;
class QuantityField;

/// Dialog that asks for rod, mean force and duration. It shows the physical values that follow from them and
/// from the dimensionless groups of the scenario (β, γ, τ, δ). Accepting changes the document in one undo
/// step.
class RigDialog : public QDialog {
    Q_OBJECT

  public:
    /// Makes the dialog. The document must outlive it, and its scenario must be dimensionless.
    explicit RigDialog(Document& document, QWidget* parent = nullptr);

    const RigChoice& choice() const { return m_choice; }
    void accept() override;

  private:
    QuantityField* addNumber(const char* key);
    void usePreset(int index);
    void showChoice();

    Document& m_document;
    PresetLibrary m_library;
    std::vector<const Preset*> m_presets;  // presets in the order of the box, where they follow "custom"
    RigChoice m_choice;
    ChoiceBox* m_rod;
    QList<QuantityField*> m_fields;
    QLabel* m_result;
    QPushButton* m_accept = nullptr;
};

/// Returns a sentence on how to get a scenario in physical units, for pages that need one.
QString waysToPhysicalUnits();

}  // namespace drillwave
