// SPDX-License-Identifier: GPL-3.0-or-later
// Page Curve, whose tab is COR–stiffness: any result over any parameter, at first e over the stiffness of the
// rock, of a drill string the efficiency.
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

/// A click loads the point under it, on a curve with the value of its family.
class CurvePage : public StudyPage {
    Q_OBJECT

  public:
    explicit CurvePage(Document& document, QWidget* parent = nullptr);

    QString title() const override;
    FigureFrame& figureFrame() const { return *m_frame; }
    /// Nothing before the first answer.
    const std::optional<StudyFigure>& figure() const { return m_figure; }
    AxisFields* axis() const { return m_axis; }
    FamilyFields* family() const { return m_family; }
    OutputBox* output() const { return m_output; }
    GoalField* goal() const { return m_goal; }
    const StudyRunner<ComparedCurveQuestion, ComparedCurve>& study() const { return m_study; }
    /// Varies the gap, from none to a few times what the bit moves in a blow.
    void varyGap();
    /// Varies that parameter around its value, for a goal to be typed. Requires that it can be varied.
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
    /// State of the controls: a question, or why there is none. Neither before the first scenario.
    struct Wish {
        std::optional<ComparedCurveQuestion> question;
        QString problem;
    };
    /// Contents of the picture.
    struct Shown {
        std::shared_ptr<const ComparedCurve> study;
        ShownUnits units;
        const Unit* xUnit = nullptr;
        std::optional<double> here;  // of the family, in the present scenario
        std::vector<Preset> presets;
        bool operator==(const Shown&) const = default;
    };
    QList<QWidget*> makeControls();
    QWidget* makePointsBox();
    /// Takes the controls that the form of the scenario has.
    void followForm();
    std::string axisText() const;
    OutputColumn column() const;
    void takeGoal();
    void showGoal();
    std::optional<double> askedGoal(const OutputColumn& of) const;
    Wish wish() const;
    StudyFamily askedFamily() const;
    std::optional<double> hereOf(const KeptParameter& parameter) const;
    /// Requires a study and a blow.
    Shown wanted() const;
    void refuse(const QString& problem);
    void draw();
    void showHere();
    void askRuns();
    void showRuns();
    struct Point {
        std::optional<double> x, y;  // as shown
    };
    Point pointOf(const SolvedBlow& blow) const;
    void click(QCPAxisRect* rect, QPointF coordinates, Qt::KeyboardModifiers modifiers);

    AxisFields* m_axis;
    FamilyFields* m_family;
    QCheckBox* m_own;
    OutputBox* m_output;
    GoalField* m_goal;
    /// The last goal of each output, in SI or dimensionless as the results were then.
    struct Goal {
        double value = 0;
        OutputUnits units = OutputUnits::dimensionless;
    };
    std::map<const Output*, Goal> m_goals;
    QCheckBox* m_closedForm;
    QComboBox* m_reference;
    QComboBox* m_points;  // of a curve that is sampled
    QWidget* m_pointsPart = nullptr;
    bool m_isSampled = false;
    FigureFrame* m_frame = nullptr;
    std::optional<StudyFigure> m_figure;
    PresetLibrary m_presets;
    QString m_problem;  // why the controls give no curve
    Shown m_shown;
    std::shared_ptr<const RunStudies<CurveQuestion, CurveStudy>::Answers> m_shownLines;  // of runs, as drawn
    RunListPtr m_shownRuns;
    StudyRunner<ComparedCurveQuestion, ComparedCurve> m_study;  // goes first: its threads work
    RunStudies<CurveQuestion, CurveStudy> m_runLines;           // goes even before
};

}  // namespace drillwave
