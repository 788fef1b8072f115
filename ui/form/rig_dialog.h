// SPDX-License-Identifier: GPL-3.0-or-later
// Asks for the rig that a scenario of dimensionless groups becomes.
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

/// Shows the values that follow from the groups and the inputs. Accepting makes the rig, in one step of the
/// document's history.
class RigDialog : public QDialog {
    Q_OBJECT

  public:
    /// The document must outlive it. Requires a dimensionless scenario.
    explicit RigDialog(Document& document, QWidget* parent = nullptr);

    const RigChoice& choice() const { return m_choice; }
    void accept() override;

  private:
    QuantityField* addNumber(const char* key);
    void usePreset(int index);
    void showChoice();

    Document& m_document;
    PresetLibrary m_library;
    std::vector<const Preset*> m_presets;  // in the order of the box, after "custom"
    RigChoice m_choice;
    ChoiceBox* m_rod;
    QList<QuantityField*> m_fields;
    QLabel* m_result;
    QPushButton* m_accept = nullptr;
};

/// Returns the ways to a scenario in physical units, for pages with nothing to show for a dimensionless one.
QString waysToPhysicalUnits();

}  // namespace drillwave
