// SPDX-License-Identifier: GPL-3.0-or-later
// Page Curve, with the tab COR–stiffness: any result over any parameter. At first it shows the coefficient of
// restitution e over the stiffness of the rock; for drill strings it shows the efficiency.
#pragma once

#include <map>

#include "core/report/figure.h"
#include "core/study/curve/compared_curve.h"
#include "ui/document/preset_library.h"
#include "ui/job/study_job.h"
#include "ui/pages/study/run_studies.h"
#include "ui/pages/study/study_page.h"
#include "ui/pages/study/study_range.h"
#include "ui/text/shown_units.h"

class QCheckBox;
class QComboBox;
class QCPAxisRect;

namespace drillwave {

class AxisFields;
class FamilyFields;
class OutputBox;
class FigureFrame;
class GoalField;

/// Page that plots a result over one parameter, with a curve for each value of a second parameter (the
/// family). A click on the plot sets the parameter to the value there. On a curve it also sets the second
/// parameter to the value of that curve.
class CurvePage : public StudyPage {
    Q_OBJECT

  public:
    explicit CurvePage(Document& document, QWidget* parent = nullptr);

    QString title() const override;
    FigureFrame& figureFrame() const { return *m_frame; }
    /// Returns the figure that is shown. Empty before the first result of the study, and while an error is
    /// shown.
    const std::optional<StudyFigure>& figure() const { return m_figure; }
    AxisFields* axis() const { return m_axis; }
    FamilyFields* family() const { return m_family; }
    OutputBox* output() const { return m_output; }
    GoalField* goal() const { return m_goal; }
    const StudyRunner<ComparedCurveQuestion, ComparedCurve>& study() const { return m_study; }
    /// Plots the selected result over the gap between bit and rock. The gap ranges from 0 to at least 4 d0
    /// (d0 is the scale of penetrations).
    void varyGap();
    /// Plots the result over `parameter`, in a range around its present value, and puts the focus into the
    /// field for the goal. Requires that the parameter can be varied.
    void seek(const KeptParameter& parameter);
    QString command() const override;
    const RunStudies<CurveQuestion, CurveStudy>& runLines() const { return m_runLines; }

  protected:
    void ask() override;
    void present() override;
    QString obstacle() const override;
    QByteArray csv() const override;
    QStringList commandWords() const override;
    void showEvent(QShowEvent* event) override;

  private:
    /// Study that the controls describe, or the reason why they describe none. Both are empty before the
    /// first scenario.
    struct Wish {
        std::optional<ComparedCurveQuestion> question;
        QString problem;
    };
    /// Data from which the plot was drawn. The plot is drawn again only if they change.
    struct Shown {
        std::shared_ptr<const ComparedCurve> study;
        ShownUnits units;
        const Unit* xUnit = nullptr;
        std::optional<double> here;  // value of the family in the present scenario
        std::vector<Preset> presets;
        bool operator==(const Shown&) const = default;
    };
    QList<QWidget*> makeControls();
    QWidget* makePointsBox();
    /// Shows the controls that suit the kind of scenario: uniform rod or drill string.
    void followForm();
    std::string axisText() const;
    OutputColumn column() const;
    void takeGoal();
    void showGoal();
    std::optional<double> askedGoal(const OutputColumn& of) const;
    Wish wish() const;
    StudyFamily askedFamily() const;
    std::optional<double> hereOf(const KeptParameter& parameter) const;
    /// Returns the data to draw now; the plot is drawn again if they differ from those drawn before. Requires
    /// that a study and a blow exist.
    Shown wanted() const;
    void refuse(const QString& problem);
    void draw();
    void showHere();
    void askRuns();
    void showRuns();
    struct Point {
        std::optional<double> x, y;  // in the units shown
    };
    Point pointOf(const SolvedBlow& blow) const;
    void click(QCPAxisRect* rect, QPointF coordinates, Qt::KeyboardModifiers modifiers);

    AxisFields* m_axis;
    FamilyFields* m_family;
    QCheckBox* m_own;
    OutputBox* m_output;
    GoalField* m_goal;
    /// Value that the user typed last as the goal for an output. It is in SI or dimensionless, as `units`
    /// says.
    struct Goal {
        double value = 0;
        OutputUnits units = OutputUnits::dimensionless;
    };
    std::map<const Output*, Goal> m_goals;
    QCheckBox* m_closedForm;
    QComboBox* m_reference;
    QComboBox* m_points;  // number of points of a curve of a drill string
    QWidget* m_pointsPart = nullptr;
    bool m_isSampled = false;
    FigureFrame* m_frame = nullptr;
    std::optional<StudyFigure> m_figure;
    PresetLibrary m_presets;
    QString m_problem;  // reason why the controls describe no study
    Shown m_shown;
    std::shared_ptr<const RunStudies<CurveQuestion, CurveStudy>::Answers> m_shownLines;  // as drawn
    RunListPtr m_shownRuns;
    StudyRunner<ComparedCurveQuestion, ComparedCurve> m_study;  // its threads use other members
    RunStudies<CurveQuestion, CurveStudy> m_runLines;           // destroyed first
};

}  // namespace drillwave
