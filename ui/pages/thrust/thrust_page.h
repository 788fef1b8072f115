// SPDX-License-Identifier: GPL-3.0-or-later
// The page Feed: which feed the blows need, and what the installed one does between them (theory §10).
#pragma once

#include "ui/job/study_job.h"
#include "ui/pages/study/study_page.h"
#include "ui/pages/thrust/thrust_picture.h"
#include "ui/pages/thrust/thrust_study.h"

namespace drillwave {

class AxisFields;
class MissingFields;
class ThrustDrag;
class ThrustPlot;
class ThrustTable;

class ThrustPage : public StudyPage {
    Q_OBJECT

  public:
    explicit ThrustPage(Document& document, QWidget* parent = nullptr);

    QString title() const override { return tr("Feed"); }
    bool shows(const Scenario& scenario) const override { return hasUnits(scenario); }
    QString elsewhere() const override;
    /// How many studies were started.
    int studies() const { return m_study.started(); }
    const ThrustPlot& thrustPlot() const { return *m_plot; }

  protected:
    void ask() override;
    void present() override;
    QString obstacle() const override;
    QByteArray csv() const override;
    QStringList commandWords() const override;

  private:
    void draw(const ThrustAnswer& answer);
    void showRuns(const ThrustAnswer& answer);
    void placeHere(const ThrustAnswer& answer);
    void refuse(const QString& why);
    void takeParameter(double shown, Qt::KeyboardModifiers modifiers);
    void hold(double shownForce);
    void moveHeld(double shownForce);

    AxisFields* m_axis;
    MissingFields* m_missing;
    ThrustTable* m_table;
    ThrustPlot* m_plot = nullptr;
    ThrustDrag* m_drag = nullptr;
    ThrustUnits m_units;
    // The line of the feed while it is dragged: the thrust, and the force where it was taken hold of [N].
    struct Held {
        int gesture = 0;
        double thrust = 0;
        double force = 0;
    };
    Held m_held;
    std::shared_ptr<const ThrustAnswer> m_shown;
    AskedStudy<ThrustQuestion, ThrustAnswer> m_study;  // goes first: its thread works
};

}  // namespace drillwave
