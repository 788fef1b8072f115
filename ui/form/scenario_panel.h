// SPDX-License-Identifier: GPL-3.0-or-later
// The form of a scenario: every parameter of the table that applies, in sections that can be folded.
#pragma once

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QObject>
#include <QPushButton>

#include "ui/document/document.h"
#include "ui/document/preset_library.h"
#include "ui/form/law_section.h"
#include "ui/form/parameter_row.h"
#include "ui/form/preset_box.h"
#include "ui/form/pulse_section.h"
#include "ui/form/section_box.h"
#include "ui/questions/questions.h"

namespace drillwave {

class ChoiceBox;

// Whether the bit meets new rock with every blow: a word, and so no row of numbers.

/// A row of its own in the grid of a section.
class IndexingBox : public QObject {
    Q_OBJECT

  public:
    /// Fills the lowest row of `grid`. The document must outlive it.
    IndexingBox(Document& document, QGridLayout* grid, QWidget* parent);

    void present(const Scenario& scenario);

  private:
    void choose(RockIndexing indexing);

    Document& m_document;
    ChoiceBox* m_box;
};

// Rows for drill strings beside the numbers: a summary with a link to the sections, and whether the hammer
// strikes again.

/// Its widgets live in the grids of two sections of the form.
class StringSection : public QObject {
    Q_OBJECT

  public:
    /// Fills the next rows of `grid`. The document must outlive it.
    StringSection(Document& document, QGridLayout* grid, QWidget* parent);

    /// Adds the row of restrikes below the rows of the hammer.
    void addRestrike(QGridLayout* grid, QWidget* parent);
    /// Requires a drill string.
    void present(const Scenario& scenario);

  signals:
    void sectionsRequested();

  private:
    void setRestrike(bool restrike);

    Document& m_document;
    QLabel* m_summary;
    QCheckBox* m_restrike = nullptr;
};

/// Shows and edits a document. Rows come only from parameters(): a new parameter there appears here.
class ScenarioPanel : public SteadyScrollArea {
    Q_OBJECT

  public:
    /// Document and questions must outlive the panel.
    ScenarioPanel(Document& document, Questions& questions, QWidget* parent = nullptr);
    ~ScenarioPanel() override;

    /// Shows the field of a parameter, by its key, and gives it the focus.
    void goTo(const QString& key);

  signals:
    /// A slider is held, and let go again; not for clicks, keys and wheel.
    void dragStarted();
    void dragEnded();
    /// The user wants to import a measured hammer blow.
    void importRequested();
    /// The user wants the value of that parameter for a given result.
    void goalRequested(const QString& key);
    /// The user wants to see the sections of the drill string.
    void sectionsRequested();

  private:
    void addTitle();
    void addSection(const QString& section, const QString& title);
    void addPresets(PresetKind kind, const QString& title, QGridLayout* grid, QWidget* parent);
    void addRow(const Parameter& parameter, const QString& sectionTitle, QGridLayout* grid, QWidget* parent);
    void reset(const Parameter& parameter);
    void beginDrag();
    void endDrag();
    void alignColumns();
    void placeGroups(ScenarioForm form);
    void orderTabs();
    void showScenario();
    void showPresets();

    struct Section {
        SectionBox* box;
        QGridLayout* grid;
        QList<ParameterRow*> rows;
    };

    Document& m_document;
    Questions& m_questions;
    PresetLibrary m_presets;
    QList<PresetBox*> m_presetBoxes;
    QLineEdit* m_title = nullptr;
    PulseSection* m_pulse = nullptr;
    StringSection* m_string = nullptr;
    LawSection* m_law = nullptr;
    IndexingBox* m_indexing = nullptr;
    QList<Section> m_sections;
    int m_gesture = m_document.newGesture();  // until edits have ended
    bool m_dragged = false;                   // a slider is held
    std::optional<ScenarioForm> m_placedFor;  // where the groups are
};

}  // namespace drillwave
