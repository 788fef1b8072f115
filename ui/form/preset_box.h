// SPDX-License-Identifier: GPL-3.0-or-later
// Box that shows which preset the values of a section equal, and offers other presets.
#pragma once

#include <QMenu>

#include "core/model/preset.h"
#include "ui/document/document.h"
#include "ui/document/preset_library.h"
#include "ui/form/choice_box.h"
#include "ui/questions/questions.h"

namespace drillwave {

/// Combo box that opens a menu instead of a list. The menu has the presets of one kind, also those of the
/// user's files, and commands to add such files.
class PresetBox : public ChoiceBox {
    Q_OBJECT

  public:
    /// Makes the box. Document, library and questions must outlive it. `part` is the name that screen readers
    /// speak, such as "Rod".
    PresetBox(PresetKind kind, const QString& part, Document& document, PresetLibrary& library,
              Questions& questions, QWidget* parent = nullptr);

    /// Shows the name of the preset that has the same values as the scenario, or "custom" if there is none.
    /// The tooltip states where the values of the preset come from.
    void present(const Scenario& scenario);
    void showPopup() override;
    /// Returns the menu that the box opens, filled with the presets available now.
    QMenu* menu();

  signals:
    /// Emitted when files of presets were read again, added or removed.
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
