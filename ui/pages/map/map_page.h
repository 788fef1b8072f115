// SPDX-License-Identifier: GPL-3.0-or-later
// The page Map: a result over two parameters, with contours, cuts, and a crosshair that moves both of them.
#pragma once

#include "core/report/map_figure.h"
#include "ui/job/study_job.h"
#include "ui/pages/map/map_question.h"
#include "ui/pages/study/study_page.h"
#include "ui/pages/study/study_range.h"

namespace drillwave {

class AxisFields;
class ChoiceBox;
class FigureFrame;
class LevelField;
class OutputBox;

class MapPage : public StudyPage {
    Q_OBJECT

  public:
    explicit MapPage(Document& document, QWidget* parent = nullptr);

    QString title() const override { return tr("Map"); }
    FigureFrame& figureFrame() const { return *m_frame; }
    /// How many studies were started.
    int studies() const { return m_study.started(); }
    /// The map so far, for the last question or for an earlier one; nullptr at first.
    const MapReport* report() const { return m_study.value(); }

  protected:
    void ask() override;
    void present() override;
    QString obstacle() const override;
    QByteArray csv() const override;
    QStringList commandWords() const override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    ChoiceBox* pointsBox();
    void wire();
    OutputColumn column() const;
    QString axisWord(const AxisFields& fields) const;
    MapStudy study() const;
    /// Takes axes and points that suit a drill string, or a uniform rod.
    void followForm();
    void offer(AxisFields& fields);
    void takeUsualLevels();
    void draw();
    QString readoutAt(QPointF pixel) const;
    void speak();
    QString hereText() const;
    void dragTo(QPointF place);
    std::vector<ParameterValue> inOrder(double x, double y) const;

    AxisFields* m_x;
    AxisFields* m_y;
    OutputBox* m_output;
    ChoiceBox* m_points;
    LevelField* m_levels;
    FigureFrame* m_frame = nullptr;
    QString m_problem;       // why the controls give no map
    QString m_readout;       // of what is below the pointer
    int m_gesture = 0;       // of the crosshair
    bool m_hasSize = false;  // of a section, on the x axis
    std::shared_ptr<const MapReport> m_shown;
    MapSection m_section;  // through the present scenario, as shown
    ShownUnits m_shownUnits;
    std::shared_ptr<std::atomic<int>> m_newest;
    StudyRunner<MapQuestion, MapReport> m_study;  // goes first: its thread works
};

}  // namespace drillwave
