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

/// Sequence of consecutive blows for the scenario of the result panel. It is computed when the values have
/// not changed for a moment, with as many blows as fit into one second. If 100 blows take longer, it is
/// computed only after follow(). The result of an earlier blow is not shown.
class ShortSequence : public QObject {
    Q_OBJECT

  public:
    explicit ShortSequence(QObject* parent = nullptr);

    /// Requests the sequence for a blow; there is none without feed force and blow frequency.
    void ask(const SolvedBlow& blow);
    /// Starts the computation although it takes longer than one second.
    void follow();
    /// Returns the result for the last blow; nullptr if there is none yet.
    const DrillingResult* result() const;
    /// Returns whether the sequence is being computed or will be soon.
    bool isAwaited() const;
    /// Returns the estimated computing time [s] while the sequence waits for follow(); otherwise nothing.
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

/// Panel with the results of a blow: required feed, energy, numbers in sections, alerts and events.
class ResultPanel : public SteadyScrollArea {
    Q_OBJECT

  public:
    explicit ResultPanel(QWidget* parent = nullptr);

    void present(const SolvedBlowPtr& blow);
    /// Sets the blow that every number is compared with, and its title; nullptr for none.
    void setReference(const SolvedBlowPtr& blow, const QString& title);
    /// Marks the event at the time cursor [t0]; none if there is no event or `time` is empty.
    void setTime(std::optional<double> time);
    /// Sets whether the results belong to an earlier input. If so, they are greyed out and copied text says
    /// so.
    void setOutOfDate(bool outOfDate);
    /// Returns all numbers as lines of "section: name<tab>value", with "<tab>difference" if there is a
    /// reference.
    QString text() const;

    /// Returns the most important results in one line: required feed force and penetration per blow.
    QString shortAnswer() const;
    AlertList* alerts() const { return m_alerts; }
    /// Scrolls to the alerts and gives them the keyboard focus.
    void goToAlerts();

  signals:
    /// Reports that shortAnswer() may have changed.
    void answered();
    /// Reports that the user has chosen an event; `time` is its global time [t0].
    void timeChosen(std::optional<double> time);
    /// Reports that the user has clicked a largest stress, which occurs at `section` (x/L) and `time` [t0].
    void placeChosen(double section, double time);
    /// Reports that the user wants to open the page Drilling.
    void drillingChosen();
    /// Reports that the user wants to set a wave loss (share that waves lose in a round trip). Without one,
    /// the results of the blow sequence are uncertain.
    void waveLossWanted();
    /// Reports that the user has clicked the parameter of an alert; `key` is its key as in parameters().
    void parameterChosen(const QString& key);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    /// Adds a section that folds. `name` is its object name and its key in the settings.
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
