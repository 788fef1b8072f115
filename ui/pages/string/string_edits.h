// SPDX-License-Identifier: GPL-3.0-or-later
// Actions on the sections that are selected in the table: add, duplicate, remove, move, repeat. Each is one
// step of the document's history.
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
    /// Document, model and table must outlive it; the actions are the table's, too.
    StringEdits(Document& document, StringModel& model, QTableView& table);

    /// The actions in the order of a bar.
    const QList<QAction*>& actions() const { return m_actions; }
    /// Menu of sections to add: presets, and the sections of the example strings.
    QMenu* addMenu() const { return m_addMenu; }
    /// The presets that can replace the selected sections.
    QMenu* replaceMenu() const { return m_replaceMenu; }
    /// Adds sections after the selected one, or after its repeat if it is the last of one; at the end if none
    /// is selected. Requires at least one section.
    void add(const std::vector<Section>& sections);
    /// Adds sections at their end of a string: adapters at the shank, bits at the rock.
    void addAt(StringEnd end, const std::vector<Section>& sections);
    /// Replaces the hammer.
    void useHammer(const SectionPreset& piston);
    /// Replaces the selected sections. Requires at least one section.
    void replace(const std::vector<Section>& sections);
    void duplicate();
    void remove();
    void move(MoveTo direction);
    /// Moves a row past those between.
    void moveRow(int from, int to);
    /// Makes a repeat of the selected rows, or leads to the number of theirs.
    void repeat();
    /// Selects the row of a spot.
    void select(const SectionSpot& spot);

  signals:
    /// Why an edit was not made; empty when one was.
    void refused(const QString& reason);

  private:
    void letRowsBeDragged();
    QAction* newAction(const QString& name, const QString& text, const QString& toolTip,
                       const QKeySequence& keys, const std::function<void()>& then);
    void fillAddMenu();
    void fillReplaceMenu();
    void addPresets();
    /// A submenu of that title.
    static QMenu* newMenu(QMenu& menu, const QString& title);
    /// Calls `then` with the sections of a rod that is chosen.
    void addRods(QMenu& menu, const std::function<void(Section)>& then, std::optional<double> length = {});
    void addPieces(QMenu& menu, SectionPresetKind kind,
                   const std::function<void(const SectionPreset&)>& then);
    void addExamples();
    void addChoice(QMenu& menu, const QString& text, const QString& toolTip,
                   const std::function<void()>& then);
    /// An action that adds sections, at an end of the string where one is given.
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
