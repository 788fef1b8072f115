// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of a solved blow, in the order in which a driller decides by them, what happened at the bit,
// and what to know about it.
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

// A short sequence of blows, solved in addition to the blow on show.

/// Follows consecutive blows as soon as the values rest, as many as fit into a second; where a hundred take
/// longer, only on request. The result of an earlier blow is not shown.
class ShortSequence : public QObject {
    Q_OBJECT

  public:
    explicit ShortSequence(QObject* parent = nullptr);

    /// Follows this blow from now on; one without feed and blow frequency has none.
    void ask(const SolvedBlow& blow);
    /// Follows the blows although they take longer.
    void follow();
    /// The result for the last blow; nullptr while there is none.
    const DrillingResult* result() const;
    /// Whether it is on its way.
    bool isAwaited() const;
    /// Returns the estimated computing time [s] while the sequence waits for follow(); otherwise nothing.
    std::optional<double> secondsOnRequest() const;

  signals:
    void changed();

  private:
    void start();

    std::optional<Scenario> m_scenario;  // that can be drilled with
    QuickMarch m_march;
    StudyJob<DrillingResult> m_job;
    bool m_isDue = false;  // requested, and not started yet
    bool m_isStarted = false;
    QTimer m_rest;
};

class ResultPanel : public SteadyScrollArea {
    Q_OBJECT

  public:
    explicit ResultPanel(QWidget* parent = nullptr);

    void present(const SolvedBlowPtr& blow);
    /// The blow that every number is compared with, and what it is called; nullptr for none.
    void setReference(const SolvedBlowPtr& blow, const QString& title);
    /// Marks the event at the time cursor t/t0, if there is one.
    void setTime(std::optional<double> time);
    /// Marks all that is shown as not of the present input, and what is copied too.
    void setOutOfDate(bool outOfDate);
    /// All numbers as lines of "name<tab>value", with a reference and "<tab>difference".
    QString text() const;

    /// Returns what a driller decides by in one line: required feed and penetration per blow.
    QString shortAnswer() const;
    AlertList* alerts() const { return m_alerts; }
    /// Brings the alerts into view, and the keyboard to them.
    void goToAlerts();

  signals:
    /// shortAnswer() may have changed.
    void answered();
    /// The user chose an event: its global time t/t0.
    void timeChosen(std::optional<double> time);
    /// The user follows a largest stress to where in the rod, x/L, and when, t/t0, it occurs.
    void placeChosen(double section, double time);
    /// The user wants to see what many blows do.
    void drillingChosen();
    /// The user wants waves to fade, so that a sequence can be resolved.
    void waveLossWanted();
    /// The user follows an alert to its parameter: the key, as in parameters().
    void parameterChosen(const QString& key);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    /// Adds a section that folds; `name` is that of its object and of its key in the settings.
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
    QLabel* m_required = nullptr;  // what single blows require
    QLabel* m_followed = nullptr;  // what the sequence gives
    StaleVeil* m_veil;
};

}  // namespace drillwave
