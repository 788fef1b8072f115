// SPDX-License-Identifier: GPL-3.0-or-later
// Shows which preset a part of the scenario agrees with, and offers the others.
#pragma once

#include <QMenu>

#include "core/model/preset.h"
#include "ui/document/document.h"
#include "ui/document/preset_library.h"
#include "ui/form/choice_box.h"
#include "ui/questions/questions.h"

namespace drillwave {

/// Looks like a combo box and opens a menu: presets of one kind, those of the user's files, and how to add
/// such files.
class PresetBox : public ChoiceBox {
    Q_OBJECT

  public:
    /// All references must outlive the box. `part` names the section in accessible names: "Rod".
    PresetBox(PresetKind kind, const QString& part, Document& document, PresetLibrary& library,
              Questions& questions, QWidget* parent = nullptr);

    /// Shows the name of the preset that the scenario agrees with, or "custom", and where its values are
    /// from.
    void present(const Scenario& scenario);
    void showPopup() override;
    /// The menu as it would open now.
    QMenu* menu();

  signals:
    /// Files of presets were read again, added or removed.
    void libraryChanged();

  private:
    QString describe(const Preset& preset) const;
    void fillMenu();
    void addPresets(QMenu* menu, const PresetSource& source);
    void addProblem(const PresetSource& source);
    void addFile();
    void explainProblem(const QString& path, const QString& problem);
    void take(const Preset& preset);

    PresetKind m_kind;
    Document& m_document;
    PresetLibrary& m_library;
    Questions& m_questions;
    QMenu* m_menu;
};

}  // namespace drillwave
