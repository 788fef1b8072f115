// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of a solved blow in the order in which a driller needs them, the events at the bit, and alerts.
#pragma once

#include <QLabel>
#include <QList>
#include <QTimer>
#include <optional>

#include "core/study/drilling/quick_march.h"
#include "ui/form/section_box.h"
#include "ui/job/solved_blow.h"
#include "ui/job/study_job.h"
#include "ui/result/alert_list.h"
#include "ui/result/energy_bar.h"
#include "ui/result/feed_text.h"
#include "ui/result/result_row.h"
#include "ui/result/stale_veil.h"

class QGridLayout;

namespace drillwave {

class EventTable;

// A short sequence of blows, computed in addition to the blow that is shown.

/// Sequence of consecutive blows for the scenario of the result panel. It is computed when the input has not
/// changed for a moment, with as many blows as fit into one second. If 100 blows take longer than this, it is
/// computed only after follow(). The result for an earlier input is not shown.
class ShortSequence : public QObject {
    Q_OBJECT

  public:
    explicit ShortSequence(QObject* parent = nullptr);

    /// Requests the sequence of blows for the scenario of a blow. There is none if the scenario has no feed
    /// force or no blow frequency.
    void ask(const SolvedBlow& blow);
    /// Starts the computation of the sequence even if it will take longer than one second; called when the
    /// user asks for it.
    void follow();
    /// Returns the result of the sequence for the blow last passed to ask(); nullptr until it is computed.
    const DrillingResult* result() const;
    /// Returns whether the sequence of blows is being computed, or will be soon. False while it waits for
    /// follow().
    bool isAwaited() const;
    /// Returns the estimated computing time of the sequence [s] if it is so long that the sequence waits for
    /// follow(); otherwise nothing.
    std::optional<double> secondsOnRequest() const;

  signals:
    void changed();

  private:
    void start();

    std::optional<Scenario> m_scenario;  // scenario of the sequence; empty if it cannot drill
    QuickMarch m_march;
    StudyJob<DrillingResult> m_job;
    bool m_isDue = false;  // whether the sequence is requested but not yet started
    bool m_isStarted = false;
    QTimer m_rest;
};

/// Panel with the results of a blow: required feed force, energy, groups of numbers, alerts and events.
class ResultPanel : public SteadyScrollArea {
    Q_OBJECT

  public:
    explicit ResultPanel(QWidget* parent = nullptr);

    void present(const SolvedBlowPtr& blow);
    /// Sets the blow with which the panel compares every number, and its title. If it is nullptr, no
    /// differences are shown.
    void setReference(const SolvedBlowPtr& blow, const QString& title);
    /// Marks the event at the time cursor. `time` is in units of t0 (duration of the hammer force) from the
    /// start of the blow. Marks no event if there is none at this time, or if `time` is empty.
    void setTime(std::optional<double> time);
    /// Sets whether the results belong to an earlier input. If so, they are greyed out and copied text says
    /// so.
    void setOutOfDate(bool outOfDate);
    /// Returns all numbers of the panel, one per line, as "section: name<tab>value". "<tab>difference"
    /// follows if there is a reference blow.
    QString text() const;

    /// Returns the most important results in one line: required feed force and penetration per blow. Shown
    /// while the panel itself may be hidden.
    QString shortAnswer() const;
    AlertList* alerts() const { return m_alerts; }
    /// Scrolls to the alerts and gives them the keyboard focus.
    void goToAlerts();

  signals:
    /// Reports that shortAnswer(), the line with the most important results, may have changed.
    void answered();
    /// Reports that the user has chosen an event of the blow, to which the time cursor should move. `time` is
    /// in units of t0 (duration of the hammer force) from the start of the blow.
    void timeChosen(std::optional<double> time);
    /// Reports that the user has clicked the row that states where and when a largest stress occurs: at
    /// `section` (x/L) and `time`. The time is in units of t0, the duration of the hammer force.
    void placeChosen(double section, double time);
    /// Reports that the user wants to open the page Drilling.
    void drillingChosen();
    /// Reports that the user wants to enter a wave loss (share of a wave that is lost in a round trip). With
    /// no wave loss, the results of the blow sequence are uncertain.
    void waveLossWanted();
    /// Reports that the user has clicked the name of a parameter in an alert. `key` is the parameter's key in
    /// scenario files, as listed by parameters().
    void parameterChosen(const QString& key);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    /// Adds a section that the user can fold and unfold. `name` is its object name, and its key in the user
    /// settings.
    SectionBox* addSection(const QString& title, const char* name);
    void addNumbers(const QString& title, const char* name, const QList<ResultEntry>& entries);
    void addRow(SectionBox* section, QGridLayout* grid, const ResultEntry& entry);
    void addEnergy();
    void addHeadline();
    void showHeadline();
    QString penetrationText() const;
    void foldSections();
    void addAlerts();
    void addFeed();
    void showFeed();
    QString followedText(const DrillingResult* result) const;
    void followLink(const QString& link);
    void addEvents();
    void alignColumns();
    void copy() const;
    void showRow(const ResultRow& row);
    void follow(const Output& stress);
    void showChange(const ResultRow& row);
    void showWorst();
    std::optional<double> worstOf(const SolvedBlow& blow) const;

    SolvedBlowPtr m_blow;
    SolvedBlowPtr m_reference;
    QString m_referenceTitle;
    WorstNeed m_worst;
    WorstNeed m_worstOfReference;
    ShortSequence m_sequence;
    QList<ResultRow> m_rows;
    QList<QGridLayout*> m_grids;
    SectionBox* m_stress = nullptr;
    EnergyBar* m_energy = nullptr;
    QLabel* m_headline = nullptr;
    EventTable* m_events = nullptr;
    AlertList* m_alerts = nullptr;
    SectionBox* m_alertSection = nullptr;
    QLabel* m_required = nullptr;  // feed force that single blows require
    QLabel* m_followed = nullptr;  // results of the blow sequence
    StaleVeil* m_veil;
};

}  // namespace drillwave
