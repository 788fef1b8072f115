// SPDX-License-Identifier: GPL-3.0-or-later
// Form of a scenario: every parameter that applies to it, in sections that can be folded.
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

// Form row for whether the bit meets new rock with every blow, which is a choice of words, not a number.

/// Row of the input form in which the user chooses whether the bit meets new rock with every blow (indexing).
class IndexingBox : public QObject {
    Q_OBJECT

  public:
    /// Adds the row at the end of `grid`. The document must outlive this object.
    IndexingBox(Document& document, QGridLayout* grid, QWidget* parent);

    void present(const Scenario& scenario);

  private:
    void choose(RockIndexing indexing);

    Document& m_document;
    ChoiceBox* m_box;
};

// Form rows of drill strings without numbers: a summary with a link to the sections, and a choice whether the
// hammer may strike again.

/// Rows of the input form that only drill strings have: a summary of the sections, and the choice whether the
/// hammer may strike again.
class StringSection : public QObject {
    Q_OBJECT

  public:
    /// Adds a row with a summary of the drill string at the end of `grid`. The document must outlive this
    /// object.
    StringSection(Document& document, QGridLayout* grid, QWidget* parent);

    /// Adds the check box for repeated strikes of the hammer at the end of `grid`, below the rows of the
    /// hammer.
    void addRestrike(QGridLayout* grid, QWidget* parent);
    /// Shows the values of a scenario, which must be a drill string.
    void present(const Scenario& scenario);

  signals:
    void sectionsRequested();

  private:
    void setRestrike(bool restrike);

    Document& m_document;
    QLabel* m_summary;
    QCheckBox* m_restrike = nullptr;
};

/// Form that shows and edits a document. Its rows are made from the list parameters(), so that a parameter
/// added to that list gets a row.
class ScenarioPanel : public SteadyScrollArea {
    Q_OBJECT

  public:
    /// Makes the form. Document and questions must outlive it.
    ScenarioPanel(Document& document, Questions& questions, QWidget* parent = nullptr);
    ~ScenarioPanel() override;

    /// Scrolls to the field of a parameter, given by its key, and gives it the focus.
    void goTo(const QString& key);

  signals:
    /// Emitted when the user starts to drag a slider; not for clicks, keys and the wheel.
    void dragStarted();
    /// Emitted when the user releases a slider.
    void dragEnded();
    /// Emitted when the user asks to import a measured hammer force.
    void importRequested();
    /// Emitted when the user asks which value of a parameter gives a wanted result. `key` names the
    /// parameter.
    void goalRequested(const QString& key);
    /// Emitted when the user asks to see the sections of the drill string.
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
    // Number of the present gesture: a group of edits that form one undo step.
    int m_gesture = m_document.newGesture();
    bool m_dragged = false;                   // true while a slider is dragged
    std::optional<ScenarioForm> m_placedFor;  // form of scenario for which the sections were last arranged
};

}  // namespace drillwave
