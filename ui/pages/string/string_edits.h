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
    /// Creates the actions on sections, such as add and remove, and adds them to the table. Document, model
    /// and table must outlive the object.
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
    /// Adds sections at one end of the drill string: adapters at the shank end, bits at the rock end.
    void addAt(StringEnd end, const std::vector<Section>& sections);
    /// Replaces the hammer of the drill string by a preset.
    void useHammer(const SectionPreset& piston);
    /// Replaces the selected sections. Requires at least one section.
    void replace(const std::vector<Section>& sections);
    void duplicate();
    void remove();
    void move(MoveTo direction);
    /// Moves row `from` to row `to` (from 0) past the rows between. Emits refused() if it would leave the
    /// hammer or the string.
    void moveRow(int from, int to);
    /// Turns the selected rows into a repeat (a group of sections that occurs several times) if they can be
    /// one. Then opens the cell with the number of repeats.
    void repeat();
    /// Selects the table row of a section. `spot` is the position of the section in the scenario file.
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
    /// Adds a submenu of rod presets. When the user chooses one, `then` is called with it as a section.
    /// `length` [m] is used for presets without a length.
    void addRods(QMenu& menu, const std::function<void(Section)>& then, std::optional<double> length = {});
    void addPieces(QMenu& menu, SectionPresetKind kind,
                   const std::function<void(const SectionPreset&)>& then);
    void addExamples();
    void addChoice(QMenu& menu, const QString& text, const QString& toolTip,
                   const std::function<void()>& then);
    /// Returns a function that adds the sections: at `end` of the string, or after the selected rows if `end`
    /// is empty.
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
