// SPDX-License-Identifier: GPL-3.0-or-later
// Actions on the selected sections in the table: add, duplicate, remove, move, repeat. Each is one undo step.
#pragma once

#include <QAction>
#include <QObject>
#include <functional>

#include "ui/document/document.h"
#include "ui/document/preset_library.h"
#include "ui/pages/string/string_model.h"

class QMenu;
class QTableView;

namespace drillwave {

class StringEdits : public QObject {
    Q_OBJECT

  public:
    /// Creates the actions and adds them to the table. Document, model and table must outlive the object.
    StringEdits(Document& document, StringModel& model, QTableView& table);

    /// Returns the actions in the order of a tool bar.
    const QList<QAction*>& actions() const { return m_actions; }
    /// Returns the menu of sections to add: presets, and the sections of the example strings.
    QMenu* addMenu() const { return m_addMenu; }
    /// Returns the menu of presets that can replace the selected sections.
    QMenu* replaceMenu() const { return m_replaceMenu; }
    /// Adds sections after the selected one. After the last section of a repeat they are added after the
    /// whole repeat; without a selection, at the end. Requires at least one section.
    void add(const std::vector<Section>& sections);
    /// Adds sections at the end of the string where they belong: adapters at the shank, bits at the rock.
    void addAt(StringEnd end, const std::vector<Section>& sections);
    /// Replaces the hammer by a preset.
    void useHammer(const SectionPreset& piston);
    /// Replaces the selected sections. Requires at least one section.
    void replace(const std::vector<Section>& sections);
    void duplicate();
    void remove();
    void move(MoveTo direction);
    /// Moves row `from` to row `to` (from 0) past the rows between. Emits refused() if it would leave the
    /// hammer or the string.
    void moveRow(int from, int to);
    /// Makes a repeat of the selected rows, or opens the cell with the number of repeats if they are one
    /// already.
    void repeat();
    /// Selects the row of a section given by its position in the file.
    void select(const SectionSpot& spot);

  signals:
    /// Reports why an edit was refused; empty after a successful edit.
    void refused(const QString& reason);

  private:
    void letRowsBeDragged();
    QAction* newAction(const QString& name, const QString& text, const QString& toolTip,
                       const QKeySequence& keys, const std::function<void()>& then);
    void fillAddMenu();
    void fillReplaceMenu();
    void addPresets();
    /// Adds a submenu with this title and returns it.
    static QMenu* newMenu(QMenu& menu, const QString& title);
    /// Adds a submenu of rod presets that calls `then` with the section of the chosen rod. `length` [m] is
    /// used for presets without a length.
    void addRods(QMenu& menu, const std::function<void(Section)>& then, std::optional<double> length = {});
    void addPieces(QMenu& menu, SectionPresetKind kind,
                   const std::function<void(const SectionPreset&)>& then);
    void addExamples();
    void addChoice(QMenu& menu, const QString& text, const QString& toolTip,
                   const std::function<void()>& then);
    /// Returns a function that adds the sections: at `end` of the string, or after the selection without it.
    std::function<void()> adding(std::vector<Section> sections, std::optional<StringEnd> end = {});
    void offer();
    std::vector<SectionSpot> selected() const;
    std::optional<SectionSpot> current() const;
    bool take(const Scenario& changed, const QString& step);
    void takeAdded(const Scenario& changed, const std::vector<Section>& sections, const SectionSpot& last);

    Document& m_document;
    StringModel& m_model;
    PresetLibrary m_presets;
    QTableView& m_table;
    QMenu* m_addMenu;
    QMenu* m_replaceMenu;
    QList<QAction*> m_actions;
    QAction* m_add;
    QAction* m_replace;
    QAction* m_duplicate;
    QAction* m_remove;
    QAction* m_up;
    QAction* m_down;
    QAction* m_repeat;
};

}  // namespace drillwave
