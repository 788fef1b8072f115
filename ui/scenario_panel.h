// The form of a scenario: every parameter of the table that applies, in sections that can be folded.
#pragma once

#include <QComboBox>
#include <QLineEdit>
#include <QScrollArea>

#include "ui/document.h"
#include "ui/parameter_row.h"
#include "ui/section_box.h"

namespace drillwave {

/// Shows and edits a document. Rows come from parameters() alone: what is added there appears here.
class ScenarioPanel : public QScrollArea {
    Q_OBJECT

  public:
    /// The document must outlive the panel.
    explicit ScenarioPanel(Document& document, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    /// Wide enough that nothing is cut off at the side.
    QSize minimumSizeHint() const override;

  signals:
    /// A slider is held, and let go again; not for clicks, keys and wheel.
    void dragStarted();
    void dragEnded();

  private:
    void addTitle();
    void addSection(const QString& section, const QString& title);
    void addShape(QGridLayout* grid, QWidget* parent);
    void addRow(const Parameter& parameter, const QString& sectionTitle, QGridLayout* grid, QWidget* parent);
    void alignColumns();
    void showScenario();
    void showShape();

    struct Section {
        SectionBox* box;
        QGridLayout* grid;
        QList<ParameterRow*> rows;
    };

    Document& m_document;
    QLineEdit* m_title = nullptr;
    QComboBox* m_shape = nullptr;
    QList<Section> m_sections;
    int m_gesture = 1;
};

}  // namespace drillwave
