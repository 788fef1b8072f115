// SPDX-License-Identifier: GPL-3.0-or-later
// The page Map: a result over two parameters, with contours and cuts. The user drags a crosshair that sets
// both parameters.
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
    /// Returns how many studies the page has started, for tests.
    int studies() const { return m_study.started(); }
    /// Returns the map as far as it is computed. It may still be the map of earlier input; nullptr before the
    /// first one.
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
    /// Selects ranges of the axes and a number of points that suit the kind of scenario: uniform rod or drill
    /// string.
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
    QString m_problem;       // reason why the controls describe no map
    QString m_readout;       // text on the point below the mouse pointer
    int m_gesture = 0;       // number of the present drag of the crosshair
    bool m_hasSize = false;  // whether x is a size of a section of a string
    std::shared_ptr<const MapReport> m_shown;
    MapSection m_section;  // cuts through the present scenario, as shown
    ShownUnits m_shownUnits;
    std::shared_ptr<std::atomic<int>> m_newest;
    StudyRunner<MapQuestion, MapReport> m_study;  // destroyed first: its thread works
};

}  // namespace drillwave
